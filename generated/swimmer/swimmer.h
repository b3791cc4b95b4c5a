/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: f1fcd16d87e2426656b1d181341ac3b7f4221d042e81bf124407e8cab858f394
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 26 distinct operations.
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
#define SWIMMER_WORST_OPERATIONS 26U
#define SWIMMER_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct swimmer_state {
    float obs[8]; /* , -1.3432261943817139 to 1.0754176378250122; -1.6053855419158936 to 1.6728030443191528; -1.6147688627243042 to 1.5566096305847168; -1.4070086479187012 to 2.155215263366699; -3.5542614459991455 to 3.5728280544281006; -3.827202796936035 to 3.846395492553711; -6.324155807495117 to 6.35818338394165; -9.29275894165039 to 9.288382530212402 */
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
