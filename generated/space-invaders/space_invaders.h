/*
 * A policy for space-invaders, score 80.39 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix space_invaders --profile fast
 * Graph SHA-256: aa7897b6b178fc99ebd8050d3e58d064855680089d016b30128b58cad8a6e11a
 * 6 teams (5 on the longest walk), 33 edges, 33 programs, 23 distinct operations.
 * A decision takes at most 28 bids and 25 operations.
 * Computes in f32 with own maths.
 */
#ifndef SPACE_INVADERS_H
#define SPACE_INVADERS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions. */
typedef enum space_invaders_action {
    SPACE_INVADERS_STAY = 0,
    SPACE_INVADERS_LEFT = 1,
    SPACE_INVADERS_RIGHT = 2,
    SPACE_INVADERS_FIRE = 3
} space_invaders_action_t;
#define SPACE_INVADERS_ACTIONS 4U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct space_invaders_state {
    float cannon_at[4]; /* -1 to 9 */
    float alien_at[3]; /* -1 to 9 */
    float alien_left_at; /* -1 to 9 */
    float alien_left_near; /* 0 to 1 */
    float alien_right_near; /* 0 to 1 */
    float own_bullet_at[2]; /* -1 to 9 */
    float own_bullet_near; /* 0 to 1 */
    float bullet_at[4]; /* -1 to 9 */
    float bullet_near[3]; /* 0 to 1 */
} space_invaders_state_t;

/* The action for a state. Pure and reentrant: no globals, no memory, no side effect. */
space_invaders_action_t space_invaders_infer(const space_invaders_state_t *state);

/* Computes the values of the state that come from an image of 10 rows, 10 columns and 6 channels, a byte each, those of a
 * cell beside each other. Rows begin stride bytes apart: 60 without gaps, never less. The image is not copied. */
void space_invaders_look(const uint8_t *image, uint32_t stride, space_invaders_state_t *state);

#ifndef SPACE_INVADERS_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 1 of 2 constants; in 1 it changes no answer to any of 1080 states.
 */
uint32_t space_invaders_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
