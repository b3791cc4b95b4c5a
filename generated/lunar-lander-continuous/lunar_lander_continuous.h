/*
 * A policy for LunarLanderContinuous-v3 of Gymnasium, score 284.81 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix lunar_lander_continuous --profile fast
 * Graph SHA-256: f233abff0d84f6b23d274ff7e785b3758728cdea4ae76155154ea0fef268d463
 * 1 team, 1 edge, 1 program, 12 distinct operations.
 * A decision takes at most 12 operations.
 * Computes in f32 with own maths.
 */
#ifndef LUNAR_LANDER_CONTINUOUS_H
#define LUNAR_LANDER_CONTINUOUS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LUNAR_LANDER_CONTINUOUS_OUTPUTS 2U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct lunar_lander_continuous_state {
    float x; /* -2.5 to 2.5 */
    float y; /* -2.5 to 2.5 */
    float vx; /* -10 to 10 */
    float vy; /* -10 to 10 */
    float angle; /* -6.2831855 to 6.2831855 */
    float spin; /* -10 to 10 */
    float left_leg; /* 0 to 1 */
    float right_leg; /* 0 to 1 */
} lunar_lander_continuous_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct lunar_lander_continuous_action {
    float main_engine; /* -1 to 1 */
    float side_engine; /* -1 to 1 */
} lunar_lander_continuous_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void lunar_lander_continuous_infer(const lunar_lander_continuous_state_t *state, lunar_lander_continuous_action_t *action);

#ifndef LUNAR_LANDER_CONTINUOUS_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 12 of 12 constants.
 */
uint32_t lunar_lander_continuous_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
