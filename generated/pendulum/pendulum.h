/*
 * A policy for pendulum, score -151.98 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix pendulum --profile fast
 * Graph SHA-256: e371857f5f2d98485533a900f5b0c18626fc44af90b3ad69194605f6c7bd3e14
 * 1 team, 2 edges, 2 programs, 14 distinct operations.
 * A decision takes at most 2 bids and 9 operations.
 * Computes in f32 with own maths.
 */
#ifndef PENDULUM_H
#define PENDULUM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define PENDULUM_OUTPUTS 1U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct pendulum_state {
    float cos_theta; /* -1 to 1 */
    float sin_theta; /* -1 to 1 */
    float omega; /* rad/s, -8 to 8 */
} pendulum_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct pendulum_action {
    float torque; /* N·m, -2 to 2 */
} pendulum_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void pendulum_infer(const pendulum_state_t *state, pendulum_action_t *action);

#ifndef PENDULUM_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 10 of 12 constants; in 2 it changes no answer to any of 1204 states.
 */
uint32_t pendulum_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
