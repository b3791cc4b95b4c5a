/*
 * A policy for Swimmer-v5 of Gymnasium, score 358.95 in validation, trained by tpg-train 0.1.0 with seed 4.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: 5f637141a7dc44d91b53d43bb274cbcfc9c048366af102d518443668c2fcf5ea
 * 1 team, 1 edge, 1 program, 28 distinct operations.
 * A decision takes at most 28 operations.
 * Computes in f32 with own maths.
 */
#ifndef SWIMMER_H
#define SWIMMER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SWIMMER_OUTPUTS 2U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct swimmer_state {
    float angle; /* -1.1418219 to 1.1901517 */
    float angle_1; /* -1.4240355 to 1.4747826 */
    float angle_2; /* -1.4165218 to 1.3934784 */
    float vx; /* -0.95189816 to 1.731387 */
    float vy; /* -3.4369788 to 3.4301186 */
    float spin; /* -3.7419472 to 3.7548954 */
    float speed_1; /* -5.163806 to 5.125205 */
    float speed_2; /* -8.226473 to 7.8422647 */
} swimmer_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct swimmer_action {
    float rotor_1; /* -1 to 1 */
    float rotor_2; /* -1 to 1 */
} swimmer_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void swimmer_infer(const swimmer_state_t *state, swimmer_action_t *action);

#ifndef SWIMMER_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 20 of 20 constants.
 */
uint32_t swimmer_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
