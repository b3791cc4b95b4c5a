/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix dodge --profile fast
 * Graph SHA-256: cdea7daabca328e27e33a768eb228f4f6759f7262ab7fd254d28e16436a5fda2
 * 2 teams (2 on the longest walk), 13 edges, 12 programs, 9 distinct operations.
 * Computes in f32 with own maths.
 */
#ifndef DODGE_H
#define DODGE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions:
 * 0 plan
 * 1 straight
 * 2 hold
 * 3 away
 * 4 field
 * 5 field_plan
 * 6 upright
 * 7 field_base_up
 * 8 field_base_down
 * 9 field_shoulder_up
 * 10 field_shoulder_down
 * 11 field_elbow_up
 * 12 field_elbow_down
 * 13 field_wrist_up
 * 14 field_wrist_down
 */
#define DODGE_ACTIONS 15U
/* Teams, and how many of them decide at most in one inference. */
#define DODGE_TEAMS 2U
#define DODGE_DEPTH 2U
/* At most, in one inference: bids looked at, operations, and sines, cosines, logarithms and exponentials among those. */
#define DODGE_WORST_BIDS 13U
#define DODGE_WORST_OPERATIONS 12U
#define DODGE_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct dodge_state {
    float left[4]; /* ticks, -4096 to 4096 */
    float near[6]; /* mm, mm/step, mm/rad, -100 to 1000; -4 to 4; -700 to 700; -700 to 700; -700 to 700; -700 to 700 */
    float second[2]; /* mm, mm/step, -100 to 1000; -4 to 4 */
    float ahead[3]; /* steps, 0 to 160; 0 to 160; 0 to 1000 */
    float progress[1]; /* steps, 0 to 255 */
    float detour[1]; /* steps, 0 to 1000 */
} dodge_state_t;

/* The action for a state, below DODGE_ACTIONS. Pure and reentrant: no globals, no memory, no side effect. */
uint16_t dodge_infer(const dodge_state_t *state);

#ifndef DODGE_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 */
uint32_t dodge_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
