/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: 67b166ee4a50b89decc98f05d051db452a31b90cf0a8686482eef25ad207213a
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
    float obs[8]; /* , -1.1418218612670898 to 1.1901516914367676; -1.4240355491638184 to 1.4747825860977173; -1.4165217876434326 to 1.3934783935546875; -0.9518981575965881 to 1.7313870191574097; -3.436978816986084 to 3.4301185607910156; -3.7419471740722656 to 3.7548954486846924; -5.163805961608887 to 5.125205039978027; -8.226472854614258 to 7.842264652252197 */
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
