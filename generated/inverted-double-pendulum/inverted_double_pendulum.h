/*
 * A policy for InvertedDoublePendulum-v5 of Gymnasium, score 9359.83 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix inverted_double_pendulum --profile fast
 * Graph SHA-256: 23d21c6ffc354225d2aca850c679caec7d888893b4bcea35fcb70a647fa62729
 * 1 team, 1 edge, 1 program, 14 distinct operations.
 * A decision takes at most 14 operations.
 * Computes in f32 with own maths.
 */
#ifndef INVERTED_DOUBLE_PENDULUM_H
#define INVERTED_DOUBLE_PENDULUM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define INVERTED_DOUBLE_PENDULUM_OUTPUTS 1U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct inverted_double_pendulum_state {
    float x; /* -0.16463087 to 0.29684538 */
    float sin_1; /* -0.14117883 to 0.11996287 */
    float sin_2; /* -0.14263926 to 0.1210145 */
    float cos_1; /* 0.99402535 to 1.001195 */
    float cos_2; /* 0.9938969 to 1.0012207 */
    float v; /* -0.32058525 to 0.24939169 */
    float omega_1; /* -0.39067128 to 0.29397532 */
    float omega_2; /* -0.31223035 to 0.38351622 */
    float constraint; /* -0.00025 to 0.00025 */
} inverted_double_pendulum_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct inverted_double_pendulum_action {
    float force; /* -1 to 1 */
} inverted_double_pendulum_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void inverted_double_pendulum_infer(const inverted_double_pendulum_state_t *state, inverted_double_pendulum_action_t *action);

#ifndef INVERTED_DOUBLE_PENDULUM_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 10 of 10 constants.
 */
uint32_t inverted_double_pendulum_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
