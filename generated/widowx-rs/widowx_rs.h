/*
 * A policy for the WidowX arm from any pose, 97.4 % success in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_rs --profile fast
 * Graph SHA-256: c354d98892012e8559994649b02ad2e36c193c87e20be9aacffa833615cf752b
 * 30 teams (16 on the longest walk), 210 edges, 156 programs, 56 distinct operations.
 * A decision takes at most 118 bids and 118 operations.
 * Computes in f32 with own maths.
 */
#ifndef WIDOWX_RS_H
#define WIDOWX_RS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions. */
typedef enum widowx_rs_action {
    WIDOWX_RS_BASE_UP = 0,
    WIDOWX_RS_BASE_DOWN = 1,
    WIDOWX_RS_SHOULDER_UP = 2,
    WIDOWX_RS_SHOULDER_DOWN = 3,
    WIDOWX_RS_ELBOW_UP = 4,
    WIDOWX_RS_ELBOW_DOWN = 5,
    WIDOWX_RS_WRIST_UP = 6,
    WIDOWX_RS_WRIST_DOWN = 7
} widowx_rs_action_t;
#define WIDOWX_RS_ACTIONS 8U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct widowx_rs_state {
    float stance[4]; /* ticks, -4095 to 4095; -3072 to 3072; -3072 to 3072; -2046 to 2046 */
    float floor; /* mm, 0 to 606 */
} widowx_rs_state_t;

/* The action for a state. Pure and reentrant: no globals, no memory, no side effect. */
widowx_rs_action_t widowx_rs_infer(const widowx_rs_state_t *state);

/* For tpg_policy_t of tpg_runtime.h: the arm's sources that make up a state, and what each action moves, in ticks. */
#define WIDOWX_RS_SOURCES { TPG_SOURCE_STANCE, TPG_SOURCE_FLOOR }
#define WIDOWX_RS_SOURCE_COUNT 2U
#define WIDOWX_RS_MOVES { { { 3, 0, 0, 0 } }, { { -3, 0, 0, 0 } }, { { 0, 3, 0, 0 } }, { { 0, -3, 0, 0 } }, { { 0, 0, 3, 0 } }, { { 0, 0, -3, 0 } }, { { 0, 0, 0, 3 } }, { { 0, 0, 0, -3 } } }

#ifndef WIDOWX_RS_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 2 of 33 constants; in 31 it changes no answer to any of 914 states.
 */
uint32_t widowx_rs_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
