/*
 * A policy for HalfCheetah-v5, score 5578.21 in validation, trained by tpg-train 0.1.0 with seed 2.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix half_cheetah --profile fast
 * Graph SHA-256: 7ef378f3cc5a30791a19fb60e0bce0a2d1d8baa319d08a1c65bdbecc6eddd4bf
 * 1 team, 1 edge, 1 program, 145 distinct operations.
 * A decision takes at most 145 operations.
 * Computes in f32 with own maths.
 */
#ifndef HALF_CHEETAH_H
#define HALF_CHEETAH_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HALF_CHEETAH_OUTPUTS 6U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct half_cheetah_state {
    float height; /* -0.2180677 to 0.13543022 */
    float pitch; /* -0.3000606 to 0.21021312 */
    float back_thigh_angle; /* -0.42632464 to 0.9315238 */
    float back_shin_angle; /* -0.97807735 to 1.0510656 */
    float back_foot_angle; /* -0.711283 to 0.893483 */
    float front_thigh_angle; /* -1.4804567 to 0.7836069 */
    float front_shin_angle; /* -0.24051364 to 0.36707708 */
    float front_foot_angle; /* -0.85147554 to 0.9253887 */
    float vx; /* -2.058686 to 9.000914 */
    float vz; /* -1.4764308 to 1.770434 */
    float pitch_speed; /* -6.2114 to 6.08957 */
    float back_thigh_speed; /* -18.8427 to 19.169788 */
    float back_shin_speed; /* -25.648323 to 22.514856 */
    float back_foot_speed; /* -29.572424 to 28.612175 */
    float front_thigh_speed; /* -26.629414 to 29.77206 */
    float front_shin_speed; /* -8.710732 to 8.808882 */
    float front_foot_speed; /* -26.645964 to 26.556257 */
} half_cheetah_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct half_cheetah_action {
    float back_thigh; /* -1 to 1 */
    float back_shin; /* -1 to 1 */
    float back_foot; /* -1 to 1 */
    float front_thigh; /* -1 to 1 */
    float front_shin; /* -1 to 1 */
    float front_foot; /* -1 to 1 */
} half_cheetah_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void half_cheetah_infer(const half_cheetah_state_t *state, half_cheetah_action_t *action);

#ifndef HALF_CHEETAH_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 89 of 89 constants.
 */
uint32_t half_cheetah_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
