/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix cartpole --profile fast
 * Graph SHA-256: b5cd35e439ef2cb063083c5c6d233008b3172426fbda1ff61d89268cd8839ef5
 * 1 teams (1 on the longest walk), 2 edges, 2 programs, 2 distinct operations.
 * Computes in f32 with own maths.
 */
#ifndef CARTPOLE_H
#define CARTPOLE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions:
 * 0 left
 * 1 right
 */
#define CARTPOLE_ACTIONS 2U
/* Teams, and how many of them decide at most in one inference. */
#define CARTPOLE_TEAMS 1U
#define CARTPOLE_DEPTH 1U
/* At most, in one inference: bids looked at, operations, and sines, cosines, logarithms and exponentials among those. */
#define CARTPOLE_WORST_BIDS 2U
#define CARTPOLE_WORST_OPERATIONS 2U
#define CARTPOLE_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct cartpole_state {
    float x[1]; /* m, -4.800000190734863 to 4.800000190734863 */
    float v[1]; /* m/s, -0.5311108827590942 to 0.5504843592643738 */
    float theta[1]; /* rad, -0.41887903213500977 to 0.41887903213500977 */
    float omega[1]; /* rad/s, -0.5196276903152466 to 0.5112185478210449 */
} cartpole_state_t;

/* The action for a state, below CARTPOLE_ACTIONS. Pure and reentrant: no globals, no memory, no side effect. */
uint16_t cartpole_infer(const cartpole_state_t *state);

#ifndef CARTPOLE_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 */
uint32_t cartpole_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
