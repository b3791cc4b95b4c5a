/*
 * A policy for cartpole, score 500 in validation, trained by tpg-train 0.1.0 with seed 2.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix cartpole --profile fast
 * Graph SHA-256: b5cd35e439ef2cb063083c5c6d233008b3172426fbda1ff61d89268cd8839ef5
 * 1 team, 2 edges, 2 programs, 2 distinct operations.
 * A decision takes at most 2 bids and 2 operations.
 * Computes in f32 with own maths.
 */
#ifndef CARTPOLE_H
#define CARTPOLE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions. */
typedef enum cartpole_action {
    CARTPOLE_LEFT = 0,
    CARTPOLE_RIGHT = 1
} cartpole_action_t;
#define CARTPOLE_ACTIONS 2U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct cartpole_state {
    float x; /* m, -4.8 to 4.8 */
    float v; /* m/s, -0.5311109 to 0.55048436 */
    float theta; /* rad, -0.41887903 to 0.41887903 */
    float omega; /* rad/s, -0.5196277 to 0.51121855 */
} cartpole_state_t;

/* The action for a state. Pure and reentrant: no globals, no memory, no side effect. */
cartpole_action_t cartpole_infer(const cartpole_state_t *state);

#ifndef CARTPOLE_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 1 of 1 constants.
 */
uint32_t cartpole_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
