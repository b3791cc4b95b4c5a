/*
 * A policy for Hopper-v5 of Gymnasium, score 2393.91 in validation, trained by tpg-train 0.1.0 with seed 3.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: 7eb551e1a4ae94a14031d271c973bb4a4dd0a017a738c426437aa239fa7b9ce4
 * 1 team, 1 edge, 1 program, 60 distinct operations.
 * A decision takes at most 60 operations.
 * Computes in f32 with own maths.
 */
#ifndef HOPPER_H
#define HOPPER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HOPPER_OUTPUTS 3U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct hopper_state {
    float height; /* 0.83112526 to 1.6484929 */
    float pitch; /* -0.15008685 to 0.03464629 */
    float thigh_angle; /* -0.85828006 to 0.17889954 */
    float leg_angle; /* -1.1709783 to 0.2400233 */
    float foot_angle; /* -1.340457 to 1.4072475 */
    float vx; /* -0.8826094 to 4.4063616 */
    float vz; /* -3.4945538 to 3.5332 */
    float pitch_speed; /* -0.6984527 to 0.9729921 */
    float thigh_speed; /* -9.8563175 to 8.929599 */
    float leg_speed; /* -12.639674 to 11.657586 */
    float foot_speed; /* -15 to 15 */
} hopper_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct hopper_action {
    float thigh; /* -1 to 1 */
    float leg; /* -1 to 1 */
    float foot; /* -1 to 1 */
} hopper_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void hopper_infer(const hopper_state_t *state, hopper_action_t *action);

#ifndef HOPPER_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 39 of 39 constants.
 */
uint32_t hopper_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
