/*
 * A policy for breakout, score 62.03 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix breakout --profile fast
 * Graph SHA-256: 07cacc72ff4d8168b411fe5271192326d495f22fd6bbc61534f2b1b6fe3ba596
 * 5 teams (5 on the longest walk), 14 edges, 14 programs, 8 distinct operations.
 * A decision takes at most 14 bids and 9 operations.
 * Computes in f32 with own maths.
 */
#ifndef BREAKOUT_H
#define BREAKOUT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions. */
typedef enum breakout_action {
    BREAKOUT_STAY = 0,
    BREAKOUT_LEFT = 1,
    BREAKOUT_RIGHT = 2
} breakout_action_t;
#define BREAKOUT_ACTIONS 3U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct breakout_state {
    float paddle_at[3]; /* -1 to 9 */
    float ball_at[2]; /* -1 to 9 */
    float ball_near; /* 0 to 1 */
    float trail_at[2]; /* -1 to 9 */
    float trail_near; /* 0 to 1 */
    float brick_near; /* 0 to 1 */
} breakout_state_t;

/* The action for a state. Pure and reentrant: no globals, no memory, no side effect. */
breakout_action_t breakout_infer(const breakout_state_t *state);

/* Computes the values of the state that come from an image of 10 rows, 10 columns and 4 channels, a byte each, those of a
 * cell beside each other. Rows begin stride bytes apart: 40 without gaps, never less. The image is not copied. */
void breakout_look(const uint8_t *image, uint32_t stride, breakout_state_t *state);

#ifndef BREAKOUT_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good. */
uint32_t breakout_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
