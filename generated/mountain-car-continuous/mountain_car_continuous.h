/*
 * A policy for mountain-car-continuous, score 99.43 in validation, trained by tpg-train 0.1.0 with seed 2.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix mountain_car_continuous --profile fast
 * Graph SHA-256: 2df7341b545eca60de0f638be2a5ace6a42c8fd5e00a17155052b0a540adac4d
 * 1 team, 2 edges, 2 programs, 4 distinct operations.
 * A decision takes at most 2 bids and 3 operations.
 * Computes in f32 with own maths.
 */
#ifndef MOUNTAIN_CAR_CONTINUOUS_H
#define MOUNTAIN_CAR_CONTINUOUS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MOUNTAIN_CAR_CONTINUOUS_OUTPUTS 1U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct mountain_car_continuous_state {
    float position; /* -1.2 to 0.6 */
    float velocity; /* -0.07 to 0.07 */
} mountain_car_continuous_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct mountain_car_continuous_action {
    float force; /* -1 to 1 */
} mountain_car_continuous_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void mountain_car_continuous_infer(const mountain_car_continuous_state_t *state, mountain_car_continuous_action_t *action);

#ifndef MOUNTAIN_CAR_CONTINUOUS_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 2 of 4 constants; in 2 it changes no answer to any of 1214 states.
 */
uint32_t mountain_car_continuous_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
