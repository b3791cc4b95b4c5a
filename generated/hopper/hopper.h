/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: d294bc47b0222a94abc7c3659d8c794cb0ec1da057122320417bd26ad0a90e67
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 61 distinct operations.
 * Computes in f32 with own maths.
 */
#ifndef HOPPER_H
#define HOPPER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HOPPER_OUTPUTS 3U
/* Teams, and how many of them decide at most in one inference. */
#define HOPPER_TEAMS 1U
#define HOPPER_DEPTH 1U
/* At most, in one inference: bids looked at, operations, and sines, cosines, logarithms and exponentials among those. */
#define HOPPER_WORST_BIDS 0U
#define HOPPER_WORST_OPERATIONS 61U
#define HOPPER_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct hopper_state {
    float obs[11]; /* , 0.8571456074714661 to 1.8482515811920166; -0.1802159696817398 to 0.056546762585639954; -0.8256809711456299 to 0.17060135304927826; -0.0061248913407325745 to 0.0070526134222745895; -1.3546653985977173 to 1.4163367748260498; -0.7724487781524658 to 3.855558156967163; -4.0611138343811035 to 4.108202934265137; -1.3541887998580933 to 1.7314413785934448; -3.2942798137664795 to 3.2574009895324707; -0.07190670818090439 to 0.0784301832318306; -15 to 15 */
} hopper_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct hopper_action {
    float action_0; /* , -1 to 1 */
    float action_1; /* , -1 to 1 */
    float action_2; /* , -1 to 1 */
} hopper_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void hopper_infer(const hopper_state_t *state, hopper_action_t *action);

#ifndef HOPPER_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 */
uint32_t hopper_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
