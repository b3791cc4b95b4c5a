/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix mountain_car --profile fast
 * Graph SHA-256: 619c5b1aa69f78a0619c4a681268039cf054605380d24d4a3f9d9b1441495474
 * 2 teams (2 on the longest walk), 7 edges, 6 programs, 11 distinct operations.
 * Computes in f32 with own maths.
 */
#ifndef MOUNTAIN_CAR_H
#define MOUNTAIN_CAR_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The actions:
 * 0 left
 * 1 none
 * 2 right
 */
#define MOUNTAIN_CAR_ACTIONS 3U
/* Teams, and how many of them decide at most in one inference. */
#define MOUNTAIN_CAR_TEAMS 2U
#define MOUNTAIN_CAR_DEPTH 2U
/* At most, in one inference: bids looked at, operations, and sines, cosines, logarithms and exponentials among those. */
#define MOUNTAIN_CAR_WORST_BIDS 7U
#define MOUNTAIN_CAR_WORST_OPERATIONS 15U
#define MOUNTAIN_CAR_WORST_MATHS_CALLS 0U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct mountain_car_state {
    float position[1]; /* , -1.2000000476837158 to 0.6000000238418579 */
    float velocity[1]; /* , -0.07000000029802322 to 0.07000000029802322 */
} mountain_car_state_t;

/* The action for a state, below MOUNTAIN_CAR_ACTIONS. Pure and reentrant: no globals, no memory, no side effect. */
uint16_t mountain_car_infer(const mountain_car_state_t *state);

#ifndef MOUNTAIN_CAR_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 */
uint32_t mountain_car_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
