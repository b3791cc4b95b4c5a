/*
 * A policy for BipedalWalker-v3 of Gymnasium, score 323.31 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix bipedal_walker --profile fast
 * Graph SHA-256: 930bc482e9b2dac7e8b66894e062e74b70c9fa9eb26564bd3db1278638a9bb94
 * 1 team, 1 edge, 1 program, 192 distinct operations.
 * A decision takes at most 192 operations.
 * Computes in f32 with own maths.
 */
#ifndef BIPEDAL_WALKER_H
#define BIPEDAL_WALKER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BIPEDAL_WALKER_OUTPUTS 4U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct bipedal_walker_state {
    float hull_angle; /* -3.1415927 to 3.1415927 */
    float hull_spin; /* -5 to 5 */
    float vx; /* -5 to 5 */
    float vy; /* -5 to 5 */
    float hip_1_angle; /* -3.1415927 to 3.1415927 */
    float hip_1_speed; /* -5 to 5 */
    float knee_1_angle; /* -3.1415927 to 3.1415927 */
    float knee_1_speed; /* -5 to 5 */
    float contact_1; /* 0 to 5 */
    float hip_2_angle; /* -3.1415927 to 3.1415927 */
    float hip_2_speed; /* -5 to 5 */
    float knee_2_angle; /* -3.1415927 to 3.1415927 */
    float knee_2_speed; /* -5 to 5 */
    float contact_2; /* 0 to 5 */
    float lidar_0; /* -1 to 1 */
    float lidar_1; /* -1 to 1 */
    float lidar_2; /* -1 to 1 */
    float lidar_3; /* -1 to 1 */
    float lidar_4; /* -1 to 1 */
    float lidar_5; /* -1 to 1 */
    float lidar_6; /* -1 to 1 */
    float lidar_7; /* -1 to 1 */
    float lidar_8; /* -1 to 1 */
    float lidar_9; /* -1 to 1 */
} bipedal_walker_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct bipedal_walker_action {
    float hip_1; /* -1 to 1 */
    float knee_1; /* -1 to 1 */
    float hip_2; /* -1 to 1 */
    float knee_2; /* -1 to 1 */
} bipedal_walker_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void bipedal_walker_infer(const bipedal_walker_state_t *state, bipedal_walker_action_t *action);

#ifndef BIPEDAL_WALKER_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 108 of 108 constants.
 */
uint32_t bipedal_walker_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
