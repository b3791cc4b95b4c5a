/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: 35a11094e952120a0c89ca943b4ff1134c6ba90081ecb5709019d335cc6126a5
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 28 distinct operations.
 * Computes in f32 with own maths.
 */
#ifndef SWIMMER_H
#define SWIMMER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SWIMMER_OUTPUTS 2U
/* Teams, and how many of them decide at most in one inference. */
#define SWIMMER_TEAMS 1U
#define SWIMMER_DEPTH 1U
/* At most, in one inference: bids looked at, operations, and sines, cosines, logarithms and exponentials among those. */
#define SWIMMER_WORST_BIDS 0U
#define SWIMMER_WORST_OPERATIONS 28U
#define SWIMMER_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct swimmer_state {
    float obs[8]; /* , -1.128920078277588 to 1.205222249031067; -1.5363115072250366 to 1.4535622596740723; -1.4418669939041138 to 1.4989898204803467; -0.955388069152832 to 1.7334280014038086; -3.4727089405059814 to 3.456476926803589; -3.7571308612823486 to 3.777353048324585; -5.308562278747559 to 5.238750457763672; -8.187785148620605 to 7.8623270988464355 */
} swimmer_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct swimmer_action {
    float action_0; /* , -1 to 1 */
    float action_1; /* , -1 to 1 */
} swimmer_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void swimmer_infer(const swimmer_state_t *state, swimmer_action_t *action);

#ifndef SWIMMER_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 */
uint32_t swimmer_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
