/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_rs --profile fast
 * Graph SHA-256: e03ca780ae182528e6a99c13b83e6fc72c791b0b352167b3af393d1d05d741ce
 * 28 teams (15 on the longest walk), 214 edges, 163 programs, 55 distinct operations.
 * Computes in f32 with own maths.
 */
#ifndef WIDOWX_RS_H
#define WIDOWX_RS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions:
 * 0 base_up
 * 1 base_down
 * 2 shoulder_up
 * 3 shoulder_down
 * 4 elbow_up
 * 5 elbow_down
 * 6 wrist_up
 * 7 wrist_down
 */
#define WIDOWX_RS_ACTIONS 8U
/* Teams, and how many of them decide at most in one inference. */
#define WIDOWX_RS_TEAMS 28U
#define WIDOWX_RS_DEPTH 15U
/* At most, in one inference: bids looked at, operations, and sines, cosines, logarithms and exponentials among those. */
#define WIDOWX_RS_WORST_BIDS 132U
#define WIDOWX_RS_WORST_OPERATIONS 132U
#define WIDOWX_RS_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct widowx_rs_state {
    float reach[3]; /* ticks, -4095 to 4095 */
    float reach_excess[3]; /* ticks, ticks, mm, -1026 to 1026 */
    float reach_pitch[1]; /* ticks, -2049 to 2049 */
    float motors_centred[4]; /* ticks, -2046 to 2046 */
} widowx_rs_state_t;

/* The action for a state, below WIDOWX_RS_ACTIONS. Pure and reentrant: no globals, no memory, no side effect. */
uint16_t widowx_rs_infer(const widowx_rs_state_t *state);

/* For tpg_policy_t of tpg_runtime.h: the arm's sources that make up a state, and what each action moves, in ticks. */
#define WIDOWX_RS_SOURCES { TPG_SOURCE_REACH, TPG_SOURCE_REACH_EXCESS, TPG_SOURCE_REACH_PITCH, TPG_SOURCE_MOTORS_CENTRED }
#define WIDOWX_RS_SOURCE_COUNT 4U
#define WIDOWX_RS_MOVES { { { 3, 0, 0, 0 } }, { { -3, 0, 0, 0 } }, { { 0, 3, 0, 0 } }, { { 0, -3, 0, 0 } }, { { 0, 0, 3, 0 } }, { { 0, 0, -3, 0 } }, { { 0, 0, 0, 3 } }, { { 0, 0, 0, -3 } } }

#ifndef WIDOWX_RS_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 */
uint32_t widowx_rs_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
