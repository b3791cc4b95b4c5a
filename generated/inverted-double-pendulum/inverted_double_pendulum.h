/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix inverted_double_pendulum --profile fast
 * Graph SHA-256: c2a4564156a88eb4a1801ee60afdb589122425609075ccfdd0cb96b607b2ae6f
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 14 distinct operations.
 * Computes in f32 with own maths.
 */
#ifndef INVERTED_DOUBLE_PENDULUM_H
#define INVERTED_DOUBLE_PENDULUM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define INVERTED_DOUBLE_PENDULUM_OUTPUTS 1U
/* Teams, and how many of them decide at most in one inference. */
#define INVERTED_DOUBLE_PENDULUM_TEAMS 1U
#define INVERTED_DOUBLE_PENDULUM_DEPTH 1U
/* At most, in one inference: bids looked at, operations, and sines, cosines, logarithms and exponentials among those. */
#define INVERTED_DOUBLE_PENDULUM_WORST_BIDS 0U
#define INVERTED_DOUBLE_PENDULUM_WORST_OPERATIONS 14U
#define INVERTED_DOUBLE_PENDULUM_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct inverted_double_pendulum_state {
    float obs[9]; /* , -0.16463087499141693 to 0.29684537649154663; -0.14117883145809174 to 0.11996287107467651; -0.14263926446437836 to 0.12101449817419052; 0.9940253496170044 to 1.001194953918457; 0.9938969016075134 to 1.001220703125; -0.3205852508544922 to 0.24939168989658356; -0.3906712830066681 to 0.2939753234386444; -0.31223034858703613 to 0.38351622223854065; -0.0002500000118743628 to 0.0002500000118743628 */
} inverted_double_pendulum_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct inverted_double_pendulum_action {
    float action; /* , -1 to 1 */
} inverted_double_pendulum_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void inverted_double_pendulum_infer(const inverted_double_pendulum_state_t *state, inverted_double_pendulum_action_t *action);

#ifndef INVERTED_DOUBLE_PENDULUM_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 */
uint32_t inverted_double_pendulum_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
