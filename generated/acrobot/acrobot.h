/*
 * A policy for acrobot, score -71.88 in validation, trained by tpg-train 0.1.0 with seed 11.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix acrobot --profile fast
 * Graph SHA-256: c746bc981049f428c5e9cd92b39b159c476562abde6afb37fa55ace167b590d0
 * 1 team, 4 edges, 4 programs, 26 distinct operations.
 * A decision takes at most 4 bids and 26 operations.
 * Computes in f32 with own maths.
 */
#ifndef ACROBOT_H
#define ACROBOT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions. */
typedef enum acrobot_action {
    ACROBOT_TORQUE_MINUS_1 = 0, /* torque -1 */
    ACROBOT_TORQUE_0 = 1, /* torque 0 */
    ACROBOT_TORQUE_1 = 2 /* torque 1 */
} acrobot_action_t;
#define ACROBOT_ACTIONS 3U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct acrobot_state {
    float cos_theta_1; /* -1 to 1 */
    float sin_theta_1; /* -1 to 1 */
    float cos_theta_2; /* -1 to 1 */
    float sin_theta_2; /* -1 to 1 */
    float omega_1; /* rad/s, -12.566371 to 12.566371 */
    float omega_2; /* rad/s, -28.274334 to 28.274334 */
} acrobot_state_t;

/* The action for a state. Pure and reentrant: no globals, no memory, no side effect. */
acrobot_action_t acrobot_infer(const acrobot_state_t *state);

#ifndef ACROBOT_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 16 of 17 constants; in 1 it changes no answer to any of 1140 states.
 */
uint32_t acrobot_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
