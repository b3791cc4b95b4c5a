/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: fb10bab75b353452c0f7ee6bdd8a9c4e3c9c4e8b9c699923ea61c53a75923706
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 67 distinct operations.
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
#define HOPPER_WORST_OPERATIONS 67U
#define HOPPER_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct hopper_state {
    float obs[11]; /* , 0.9885297417640686 to 1.7001316547393799; -0.22649134695529938 to 0.20725364983081818; -0.6324189901351929 to 0.1609724909067154; -1.0293190479278564 to 0.2524624168872833; -1.3216780424118042 to 1.2777830362319946; -0.7767627835273743 to 3.8771281242370605; -3.8018062114715576 to 3.816553831100464; -5.869260787963867 to 5.131644248962402; -7.1290507316589355 to 7.402948379516602; -10.13048267364502 to 8.481813430786133; -15 to 15 */
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
