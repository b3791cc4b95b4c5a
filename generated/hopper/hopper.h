/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: 45db48cea868239f6c7da6d4b7ab29f24a36ef767f572bf3ef94bc12a4be3468
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 60 distinct operations.
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
#define HOPPER_WORST_OPERATIONS 60U
#define HOPPER_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct hopper_state {
    float obs[11]; /* , 0.8311252593994141 to 1.6484929323196411; -0.15008684992790222 to 0.03464629128575325; -0.8582800626754761 to 0.17889954149723053; -1.170978307723999 to 0.24002330005168915; -1.3404569625854492 to 1.407247543334961; -0.8826094269752502 to 4.4063615798950195; -3.494553804397583 to 3.5332000255584717; -0.6984527111053467 to 0.9729921221733093; -9.856317520141602 to 8.929598808288574; -12.639674186706543 to 11.657586097717285; -15 to 15 */
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
