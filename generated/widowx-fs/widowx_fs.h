/*
 * A policy for the WidowX arm from its home pose, 98.7 % success in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_fs --profile fast
 * Graph SHA-256: e6794520ca2e312cdd2e5882de94ac2dc889564793be68cfa3b4c3c8774c71d2
 * 31 teams (18 on the longest walk), 188 edges, 153 programs, 52 distinct operations.
 * A decision takes at most 113 bids and 108 operations.
 * Computes in f32 with own maths.
 */
#ifndef WIDOWX_FS_H
#define WIDOWX_FS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions. */
typedef enum widowx_fs_action {
    WIDOWX_FS_BASE_UP = 0,
    WIDOWX_FS_BASE_DOWN = 1,
    WIDOWX_FS_SHOULDER_UP = 2,
    WIDOWX_FS_SHOULDER_DOWN = 3,
    WIDOWX_FS_ELBOW_UP = 4,
    WIDOWX_FS_ELBOW_DOWN = 5,
    WIDOWX_FS_WRIST_UP = 6,
    WIDOWX_FS_WRIST_DOWN = 7
} widowx_fs_action_t;
#define WIDOWX_FS_ACTIONS 8U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct widowx_fs_state {
    float polar[3]; /* mm, -449 to 449 */
} widowx_fs_state_t;

/* The action for a state. Pure and reentrant: no globals, no memory, no side effect. */
widowx_fs_action_t widowx_fs_infer(const widowx_fs_state_t *state);

/* For tpg_policy_t of tpg_runtime.h: the arm's sources that make up a state, and what each action moves, in ticks. */
#define WIDOWX_FS_SOURCES { TPG_SOURCE_POLAR }
#define WIDOWX_FS_SOURCE_COUNT 1U
#define WIDOWX_FS_MOVES { { { 3, 0, 0, 0 } }, { { -3, 0, 0, 0 } }, { { 0, 3, 0, 0 } }, { { 0, -3, 0, 0 } }, { { 0, 0, 3, 0 } }, { { 0, 0, -3, 0 } }, { { 0, 0, 0, 3 } }, { { 0, 0, 0, -3 } } }

#ifndef WIDOWX_FS_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 4 of 56 constants; in 52 it changes no answer to any of 942 states.
 */
uint32_t widowx_fs_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
