/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_rs --profile fast
 * Graph SHA-256: e03ca780ae182528e6a99c13b83e6fc72c791b0b352167b3af393d1d05d741ce
 * 28 teams (15 on the longest walk), 214 edges, 163 programs, 55 distinct operations.
 * Computes in f32 with own maths.
 */
#include "widowx_rs.h"

#include <float.h>
#include <math.h>

#ifdef __FAST_MATH__
#error "fast-math reorders operations and drops NaN: the policy would act differently"
#endif
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD != 0)
#error "float expressions must be computed in float: the policy would act differently"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#else
/* With GCC in GNU mode on a machine with fused multiply-add, pass -ffp-contract=off (-std=c99 implies it). */
#endif

static float widowx_rs_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float widowx_rs_min(float a, float b)
{
    return (a < b) ? a : b;
}

static float widowx_rs_max(float a, float b)
{
    return (a > b) ? a : b;
}

static uint32_t widowx_rs_team_0(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 5U;
    const float v2 = state->reach[0] * 0.0F;
    vertex = (v2 >= best) ? 28U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v7 = fabsf(state->reach_pitch[0]);
    vertex = (v7 >= best) ? 1U : vertex;
    best = (v7 > best) ? v7 : best;
    const float v10 = 104.24504F * state->reach_excess[1];
    vertex = (v10 >= best) ? 2U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v11 = state->reach_excess[0] - state->reach_pitch[0];
    vertex = (v11 >= best) ? 3U : vertex;
    best = (v11 > best) ? v11 : best;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 4U : vertex;
    best = (v12 > best) ? v12 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    best = (zero > best) ? zero : best;
    const float v5 = state->reach[2] * state->reach_excess[0];
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v13 = fabsf(state->reach[0]);
    vertex = (v13 >= best) ? 29U : vertex;
    best = (v13 > best) ? v13 : best;
    const float v15 = widowx_rs_max(state->reach_pitch[0], 82.87463F);
    const float v16 = state->reach[0] * v15;
    vertex = (v16 >= best) ? 5U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_11(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v17 = state->reach[0] - state->reach_pitch[0];
    vertex = (v17 >= best) ? 3U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 6U : vertex;
    best = (v12 > best) ? v12 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v20 = widowx_rs_max(state->reach[0], state->reach_pitch[0]);
    const float v21 = widowx_rs_min(v20, state->reach[1]);
    vertex = (v21 >= best) ? 30U : vertex;
    best = (v21 > best) ? v21 : best;
    const float v22 = widowx_rs_max(state->reach[0], state->reach[2]);
    vertex = (v22 >= best) ? 8U : vertex;
    best = (v22 > best) ? v22 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 35U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v26 = fabsf(state->motors_centred[2]);
    const float v27 = widowx_rs_min(v26, state->reach[1]);
    vertex = (v27 >= best) ? 30U : vertex;
    best = (v27 > best) ? v27 : best;
    const float v30 = widowx_rs_negate_if_less(state->reach[2], state->reach_excess[0]);
    const float v31 = v30 - state->reach[1];
    vertex = (v31 >= best) ? 3U : vertex;
    best = (v31 > best) ? v31 : best;
    const float v33 = widowx_rs_min(81.83404F, state->reach[0]);
    vertex = (v33 >= best) ? 28U : vertex;
    best = (v33 > best) ? v33 : best;
    const float v36 = widowx_rs_min(state->reach_excess[2], 17.596085F);
    vertex = (v36 >= best) ? 9U : vertex;
    best = (v36 > best) ? v36 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_15(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 8U;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 8U : vertex;
    best = (v12 > best) ? v12 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 10U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v37 = widowx_rs_min(state->reach_pitch[0], 17.596085F);
    vertex = (v37 >= best) ? 9U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v17 = state->reach[0] - state->reach_pitch[0];
    vertex = (v17 >= best) ? 3U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v36 = widowx_rs_min(state->reach_excess[2], 17.596085F);
    vertex = (v36 >= best) ? 9U : vertex;
    best = (v36 > best) ? v36 : best;
    const float v41 = state->reach[0] - 9.366141F;
    vertex = (v41 >= best) ? 11U : vertex;
    best = (v41 > best) ? v41 : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 12U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v22 = widowx_rs_max(state->reach[0], state->reach[2]);
    vertex = (v22 >= best) ? 8U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_23(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 15U;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 12U : vertex;
    best = (v12 > best) ? v12 : best;
    vertex = (state->reach[0] >= best) ? 13U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    best = (zero > best) ? zero : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 35U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v42 = widowx_rs_min(0.0F, state->reach_excess[1]);
    vertex = (v42 >= best) ? 14U : vertex;
    best = (v42 > best) ? v42 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v44 = widowx_rs_negate_if_less(2.633784F, state->reach[0]);
    const float v45 = widowx_rs_negate_if_less(state->reach_pitch[0], v44);
    vertex = (v45 >= best) ? 15U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_5(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 33U;
    const float v15 = widowx_rs_max(state->reach_pitch[0], 82.87463F);
    const float v16 = state->reach[0] * v15;
    vertex = (v16 >= best) ? 28U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v26 = fabsf(state->motors_centred[2]);
    const float v27 = widowx_rs_min(v26, state->reach[1]);
    vertex = (v27 >= best) ? 30U : vertex;
    best = (v27 > best) ? v27 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 16U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v13 = fabsf(state->reach[0]);
    vertex = (v13 >= best) ? 29U : vertex;
    best = (v13 > best) ? v13 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v30 = widowx_rs_negate_if_less(state->reach[2], state->reach_excess[0]);
    const float v31 = v30 - state->reach[1];
    vertex = (v31 >= best) ? 17U : vertex;
    best = (v31 > best) ? v31 : best;
    const float v22 = widowx_rs_max(state->reach[0], state->reach[2]);
    vertex = (v22 >= best) ? 18U : vertex;
    best = (v22 > best) ? v22 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 33U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_1(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 4U;
    const float v5 = state->reach[2] * state->reach_excess[0];
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v46 = state->reach[2] * state->reach_excess[1];
    vertex = (v46 >= best) ? 8U : vertex;
    best = (v46 > best) ? v46 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v15 = widowx_rs_max(state->reach_pitch[0], 82.87463F);
    const float v16 = state->reach[0] * v15;
    vertex = (v16 >= best) ? 19U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    vertex = (v48 >= best) ? 1U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 20U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 4U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_12(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 13U;
    const float v20 = widowx_rs_max(state->reach[0], state->reach_pitch[0]);
    vertex = (v20 >= best) ? 21U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v50 = state->reach_pitch[0] - 5.2186666F;
    vertex = (v50 >= best) ? 28U : vertex;
    best = (v50 > best) ? v50 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v15 = widowx_rs_max(state->reach_pitch[0], 82.87463F);
    const float v16 = state->reach[0] * v15;
    vertex = (v16 >= best) ? 28U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 8U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v33 = widowx_rs_min(81.83404F, state->reach[0]);
    vertex = (v33 >= best) ? 28U : vertex;
    best = (v33 > best) ? v33 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 14U : vertex;
    best = (zero > best) ? zero : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v22 = widowx_rs_max(state->reach[0], state->reach[2]);
    vertex = (v22 >= best) ? 32U : vertex;
    best = (v22 > best) ? v22 : best;
    const float v51 = state->reach_excess[2] / 17.596085F;
    vertex = (v51 >= best) ? 9U : vertex;
    best = (v51 > best) ? v51 : best;
    vertex = (state->reach[0] >= best) ? 13U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_29(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v52 = state->reach[0] / state->reach_excess[2];
    vertex = (v52 >= best) ? 35U : vertex;
    best = (v52 > best) ? v52 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_21(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 34U;
    const float v54 = state->reach[0] - 7.9593115F;
    vertex = (v54 >= best) ? 28U : vertex;
    best = (v54 > best) ? v54 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 33U : vertex;
    best = (zero > best) ? zero : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    const float v55 = state->reach[0] - v48;
    vertex = (v55 >= best) ? 28U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v56 = widowx_rs_negate_if_less(state->reach[0], 0.0F);
    vertex = (v56 >= best) ? 22U : vertex;
    best = (v56 > best) ? v56 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 12U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v58 = widowx_rs_min(77.8404F, state->reach[0]);
    vertex = (v58 >= best) ? 28U : vertex;
    best = (v58 > best) ? v58 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v59 = state->reach[2] + state->reach_pitch[0];
    vertex = (v59 >= best) ? 34U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_17(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v44 = widowx_rs_negate_if_less(2.633784F, state->reach[0]);
    const float v45 = widowx_rs_negate_if_less(state->reach_pitch[0], v44);
    vertex = (v45 >= best) ? 15U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 35U : vertex;
    best = (v25 > best) ? v25 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    best = (zero > best) ? zero : best;
    vertex = (state->reach[0] >= best) ? 23U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    const float v60 = state->reach[0] * v48;
    vertex = (v60 >= best) ? 28U : vertex;
    best = (v60 > best) ? v60 : best;
    const float v13 = fabsf(state->reach[0]);
    vertex = (v13 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_20(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    const float v55 = state->reach[0] - v48;
    vertex = (v55 >= best) ? 28U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v60 = state->reach[0] * v48;
    vertex = (v60 >= best) ? 28U : vertex;
    best = (v60 > best) ? v60 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 12U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v58 = widowx_rs_min(77.8404F, state->reach[0]);
    vertex = (v58 >= best) ? 28U : vertex;
    best = (v58 > best) ? v58 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_16(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 30U;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 12U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 8U : vertex;
    best = (v12 > best) ? v12 : best;
    const float v37 = widowx_rs_min(state->reach_pitch[0], 17.596085F);
    vertex = (v37 >= best) ? 9U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v61 = state->reach_excess[0] - state->reach[0];
    vertex = (v61 >= best) ? 7U : vertex;
    best = (v61 > best) ? v61 : best;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    const float v63 = state->reach_excess[1] / state->motors_centred[3];
    const float v64 = v48 - v63;
    const float v65 = state->reach[0] * v64;
    vertex = (v65 >= best) ? 8U : vertex;
    best = (v65 > best) ? v65 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 29U : vertex;
    best = (zero > best) ? zero : best;
    const float v22 = widowx_rs_max(state->reach[0], state->reach[2]);
    vertex = (v22 >= best) ? 8U : vertex;
    best = (v22 > best) ? v22 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_27(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 24U;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 29U : vertex;
    best = (zero > best) ? zero : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 35U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v67 = state->reach[0] + state->motors_centred[1];
    vertex = (v67 >= best) ? 24U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_26(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 12U;
    const float v54 = state->reach[0] - 7.9593115F;
    vertex = (v54 >= best) ? 28U : vertex;
    best = (v54 > best) ? v54 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 33U : vertex;
    best = (zero > best) ? zero : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v33 = widowx_rs_min(81.83404F, state->reach[0]);
    vertex = (v33 >= best) ? 28U : vertex;
    best = (v33 > best) ? v33 : best;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    const float v60 = state->reach[0] * v48;
    vertex = (v60 >= best) ? 28U : vertex;
    best = (v60 > best) ? v60 : best;
    const float v30 = widowx_rs_negate_if_less(state->reach[2], state->reach_excess[0]);
    vertex = (v30 >= best) ? 12U : vertex;
    best = (v30 > best) ? v30 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 12U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_25(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 34U;
    const float v13 = fabsf(state->reach[0]);
    vertex = (v13 >= best) ? 29U : vertex;
    best = (v13 > best) ? v13 : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v68 = state->reach[1] + state->reach[1];
    vertex = (v68 >= best) ? 33U : vertex;
    best = (v68 > best) ? v68 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 35U : vertex;
    best = (zero > best) ? zero : best;
    const float v59 = state->reach[2] + state->reach_pitch[0];
    vertex = (v59 >= best) ? 34U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_24(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v68 = state->reach[1] + state->reach[1];
    vertex = (v68 >= best) ? 33U : vertex;
    best = (v68 > best) ? v68 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_7(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 20U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v20 = widowx_rs_max(state->reach[0], state->reach_pitch[0]);
    vertex = (v20 >= best) ? 21U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v70 = widowx_rs_max(state->motors_centred[3], (-52.018345F));
    vertex = (v70 >= best) ? 25U : vertex;
    best = (v70 > best) ? v70 : best;
    const float v15 = widowx_rs_max(state->reach_pitch[0], 82.87463F);
    const float v16 = state->reach[0] * v15;
    vertex = (v16 >= best) ? 28U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v58 = widowx_rs_min(77.8404F, state->reach[0]);
    vertex = (v58 >= best) ? 28U : vertex;
    best = (v58 > best) ? v58 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 33U : vertex;
    best = (zero > best) ? zero : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v59 = state->reach[2] + state->reach_pitch[0];
    vertex = (v59 >= best) ? 34U : vertex;
    best = (v59 > best) ? v59 : best;
    const float v13 = fabsf(state->reach[0]);
    vertex = (v13 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_9(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 30U;
    const float v17 = state->reach[0] - state->reach_pitch[0];
    vertex = (v17 >= best) ? 3U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v71 = state->reach[2] - state->reach_excess[0];
    vertex = (v71 >= best) ? 8U : vertex;
    best = (v71 > best) ? v71 : best;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 6U : vertex;
    best = (v12 > best) ? v12 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v26 = fabsf(state->motors_centred[2]);
    const float v27 = widowx_rs_min(v26, state->reach[1]);
    vertex = (v27 >= best) ? 30U : vertex;
    best = (v27 > best) ? v27 : best;
    const float v22 = widowx_rs_max(state->reach[0], state->reach[2]);
    vertex = (v22 >= best) ? 8U : vertex;
    best = (v22 > best) ? v22 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    best = (zero > best) ? zero : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 35U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v37 = widowx_rs_min(state->reach_pitch[0], 17.596085F);
    vertex = (v37 >= best) ? 9U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v73 = widowx_rs_min(36.712555F, state->reach[1]);
    vertex = (v73 >= best) ? 30U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_6(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 3U;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 30U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v71 = state->reach[2] - state->reach_excess[0];
    vertex = (v71 >= best) ? 8U : vertex;
    best = (v71 > best) ? v71 : best;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 32U : vertex;
    best = (v12 > best) ? v12 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v73 = widowx_rs_min(36.712555F, state->reach[1]);
    vertex = (v73 >= best) ? 30U : vertex;
    best = (v73 > best) ? v73 : best;
    const float v26 = fabsf(state->motors_centred[2]);
    const float v27 = widowx_rs_min(v26, state->reach[1]);
    vertex = (v27 >= best) ? 30U : vertex;
    best = (v27 > best) ? v27 : best;
    const float v22 = widowx_rs_max(state->reach[0], state->reach[2]);
    vertex = (v22 >= best) ? 8U : vertex;
    best = (v22 > best) ? v22 : best;
    const float v29 = widowx_rs_min(state->reach[2], (-12.947205F));
    vertex = (v29 >= best) ? 9U : vertex;
    best = (v29 > best) ? v29 : best;
    const float v36 = widowx_rs_min(state->reach_excess[2], 17.596085F);
    vertex = (v36 >= best) ? 9U : vertex;
    best = (v36 > best) ? v36 : best;
    const float v37 = widowx_rs_min(state->reach_pitch[0], 17.596085F);
    vertex = (v37 >= best) ? 9U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v17 = state->reach[0] - state->reach_pitch[0];
    vertex = (v17 >= best) ? 3U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_4(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 4U : vertex;
    best = (v12 > best) ? v12 : best;
    const float v15 = widowx_rs_max(state->reach_pitch[0], 82.87463F);
    const float v16 = state->reach[0] * v15;
    vertex = (v16 >= best) ? 28U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v5 = state->reach[2] * state->reach_excess[0];
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 1U : vertex;
    best = (zero > best) ? zero : best;
    const float v20 = widowx_rs_max(state->reach[0], state->reach_pitch[0]);
    const float v75 = widowx_rs_min(v20, 5.95553F);
    vertex = (v75 >= best) ? 30U : vertex;
    best = (v75 > best) ? v75 : best;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    const float v60 = state->reach[0] * v48;
    vertex = (v60 >= best) ? 28U : vertex;
    best = (v60 > best) ? v60 : best;
    const float v50 = state->reach_pitch[0] - 5.2186666F;
    vertex = (v50 >= best) ? 28U : vertex;
    best = (v50 > best) ? v50 : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v7 = fabsf(state->reach_pitch[0]);
    vertex = (v7 >= best) ? 1U : vertex;
    best = (v7 > best) ? v7 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v2 = state->reach[0] * 0.0F;
    vertex = (v2 >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_10(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 24U;
    const float v54 = state->reach[0] - 7.9593115F;
    vertex = (v54 >= best) ? 28U : vertex;
    best = (v54 > best) ? v54 : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    const float v60 = state->reach[0] * v48;
    vertex = (v60 >= best) ? 28U : vertex;
    best = (v60 > best) ? v60 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 12U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 24U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_13(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v41 = state->reach[0] - 9.366141F;
    vertex = (v41 >= best) ? 2U : vertex;
    best = (v41 > best) ? v41 : best;
    const float v37 = widowx_rs_min(state->reach_pitch[0], 17.596085F);
    vertex = (v37 >= best) ? 9U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v22 = widowx_rs_max(state->reach[0], state->reach[2]);
    vertex = (v22 >= best) ? 8U : vertex;
    best = (v22 > best) ? v22 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v17 = state->reach[0] - state->reach_pitch[0];
    vertex = (v17 >= best) ? 3U : vertex;
    best = (v17 > best) ? v17 : best;
    vertex = (state->reach[0] >= best) ? 13U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 26U : vertex;
    best = (v25 > best) ? v25 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 29U : vertex;
    best = (zero > best) ? zero : best;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 8U : vertex;
    best = (v12 > best) ? v12 : best;
    const float v15 = widowx_rs_max(state->reach_pitch[0], 82.87463F);
    const float v16 = state->reach[0] * v15;
    vertex = (v16 >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_22(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v48 = widowx_rs_max(state->reach_pitch[0], 59.26271F);
    const float v55 = state->reach[0] - v48;
    vertex = (v55 >= best) ? 28U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v13 = fabsf(state->reach[0]);
    vertex = (v13 >= best) ? 29U : vertex;
    best = (v13 > best) ? v13 : best;
    const float v60 = state->reach[0] * v48;
    vertex = (v60 >= best) ? 28U : vertex;
    best = (v60 > best) ? v60 : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 12U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v33 = widowx_rs_min(81.83404F, state->reach[0]);
    vertex = (v33 >= best) ? 28U : vertex;
    best = (v33 > best) ? v33 : best;
    const float v44 = widowx_rs_negate_if_less(2.633784F, state->reach[0]);
    const float v45 = widowx_rs_negate_if_less(state->reach_pitch[0], v44);
    vertex = (v45 >= best) ? 15U : vertex;
    best = (v45 > best) ? v45 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_18(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v58 = widowx_rs_min(77.8404F, state->reach[0]);
    vertex = (v58 >= best) ? 28U : vertex;
    best = (v58 > best) ? v58 : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const float v77 = (-190.21367F) - state->reach_pitch[0];
    vertex = (v77 >= best) ? 34U : vertex;
    best = (v77 > best) ? v77 : best;
    const float v67 = state->reach[0] + state->motors_centred[1];
    vertex = (v67 >= best) ? 24U : vertex;
    best = (v67 > best) ? v67 : best;
    const float v78 = widowx_rs_min(state->reach[0], state->motors_centred[1]);
    vertex = (v78 >= best) ? 27U : vertex;
    best = (v78 > best) ? v78 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_28(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v79 = state->reach_pitch[0] - state->motors_centred[2];
    vertex = (v79 >= best) ? 35U : vertex;
    best = (v79 > best) ? v79 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 34U : vertex;
    best = (zero > best) ? zero : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_8(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 7U;
    const float v50 = state->reach_pitch[0] - 5.2186666F;
    vertex = (v50 >= best) ? 28U : vertex;
    best = (v50 > best) ? v50 : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 35U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v30 = widowx_rs_negate_if_less(state->reach[2], state->reach_excess[0]);
    const float v31 = v30 - state->reach[1];
    vertex = (v31 >= best) ? 17U : vertex;
    best = (v31 > best) ? v31 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v37 = widowx_rs_min(state->reach_pitch[0], 17.596085F);
    vertex = (v37 >= best) ? 9U : vertex;
    best = (v37 > best) ? v37 : best;
    vertex = (0.05277237F >= best) ? 35U : vertex;
    best = (0.05277237F > best) ? 0.05277237F : best;
    const float v20 = widowx_rs_max(state->reach[0], state->reach_pitch[0]);
    vertex = (v20 >= best) ? 21U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v81 = widowx_rs_min(state->reach_excess[0], state->motors_centred[1]);
    const float v82 = v81 - state->reach[0];
    vertex = (v82 >= best) ? 7U : vertex;
    best = (v82 > best) ? v82 : best;
    const float v58 = widowx_rs_min(77.8404F, state->reach[0]);
    vertex = (v58 >= best) ? 28U : vertex;
    best = (v58 > best) ? v58 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_14(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 8U;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 33U : vertex;
    best = (zero > best) ? zero : best;
    const float v25 = state->motors_centred[2] / 99.55378F;
    vertex = (v25 >= best) ? 35U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v39 = widowx_rs_min(71.53701F, state->reach[1]);
    vertex = (v39 >= best) ? 30U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v83 = state->reach[0] * state->reach_pitch[0];
    vertex = (v83 >= best) ? 8U : vertex;
    best = (v83 > best) ? v83 : best;
    const float v18 = 0.0F - state->reach[0];
    vertex = (v18 >= best) ? 7U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v37 = widowx_rs_min(state->reach_pitch[0], 17.596085F);
    vertex = (v37 >= best) ? 9U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v12 = state->reach[2] - state->reach_pitch[0];
    vertex = (v12 >= best) ? 8U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_19(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 30U;
    const float v13 = fabsf(state->reach[0]);
    vertex = (v13 >= best) ? 29U : vertex;
    best = (v13 > best) ? v13 : best;
    vertex = (state->reach[0] >= best) ? 28U : vertex;
    best = (state->reach[0] > best) ? state->reach[0] : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 30U : vertex;
    return vertex;
}

/* Teams are numbered from 0, which is the root; the actions follow them. */
uint16_t widowx_rs_infer(const widowx_rs_state_t *state)
{
    uint32_t vertex = 0U;
    uint32_t hop;

    for (hop = 0U; (hop < WIDOWX_RS_DEPTH) && (vertex < WIDOWX_RS_TEAMS); hop++) {
        switch (vertex) {
        case 0U:
            vertex = widowx_rs_team_0(state);
            break;
        case 1U:
            vertex = widowx_rs_team_11(state);
            break;
        case 2U:
            vertex = widowx_rs_team_15(state);
            break;
        case 3U:
            vertex = widowx_rs_team_23(state);
            break;
        case 4U:
            vertex = widowx_rs_team_5(state);
            break;
        case 5U:
            vertex = widowx_rs_team_1(state);
            break;
        case 6U:
            vertex = widowx_rs_team_12(state);
            break;
        case 7U:
            vertex = widowx_rs_team_29(state);
            break;
        case 8U:
            vertex = widowx_rs_team_21(state);
            break;
        case 9U:
            vertex = widowx_rs_team_17(state);
            break;
        case 10U:
            vertex = widowx_rs_team_20(state);
            break;
        case 11U:
            vertex = widowx_rs_team_16(state);
            break;
        case 12U:
            vertex = widowx_rs_team_27(state);
            break;
        case 13U:
            vertex = widowx_rs_team_26(state);
            break;
        case 14U:
            vertex = widowx_rs_team_25(state);
            break;
        case 15U:
            vertex = widowx_rs_team_24(state);
            break;
        case 16U:
            vertex = widowx_rs_team_7(state);
            break;
        case 17U:
            vertex = widowx_rs_team_9(state);
            break;
        case 18U:
            vertex = widowx_rs_team_6(state);
            break;
        case 19U:
            vertex = widowx_rs_team_4(state);
            break;
        case 20U:
            vertex = widowx_rs_team_10(state);
            break;
        case 21U:
            vertex = widowx_rs_team_13(state);
            break;
        case 22U:
            vertex = widowx_rs_team_22(state);
            break;
        case 23U:
            vertex = widowx_rs_team_18(state);
            break;
        case 24U:
            vertex = widowx_rs_team_28(state);
            break;
        case 25U:
            vertex = widowx_rs_team_8(state);
            break;
        case 26U:
            vertex = widowx_rs_team_14(state);
            break;
        case 27U:
            vertex = widowx_rs_team_19(state);
            break;
        default:
            vertex = WIDOWX_RS_TEAMS; /* never: every team has its case */
            break;
        }
    }
    vertex -= WIDOWX_RS_TEAMS;
    return (uint16_t)vertex;
}
#ifndef WIDOWX_RS_NO_SELFTEST

uint32_t widowx_rs_selftest(void)
{
    static const widowx_rs_state_t states[16] = {
        { { -798.6424F, -2578.1226F, 593.26575F }, { -575.946F, -443.8669F, 189.12798F }, { -159.46066F }, { -1421.3452F, 766.80206F, 422.75284F, -34.25586F } },
        { { 632.34283F, -2460.9207F, -1450.4905F }, { -95.50065F, -450.97064F, 440.94708F }, { 1689.8304F }, { 1829.6047F, -750.38293F, -319.8223F, -40.3016F } },
        { { -840.831F, -2987.8423F, -2771.4375F }, { -646.1142F, 52.37724F, -208.21704F }, { -1686.6692F }, { -1634.9398F, 1004.6203F, 398.9604F, -801.5298F } },
        { { 652.5139F, 1417.7134F, 1257.3729F }, { -567.54034F, 929.83636F, -333.8488F }, { 543.07806F }, { 1243.5132F, 166.43321F, 817.5973F, -246.93724F } },
        { { -189.70348F, 2593.9292F, -991.9888F }, { 258.1796F, -447.89325F, -245.30754F }, { 294.4934F }, { 1785.8829F, -317.30862F, 833.3824F, 1015.2186F } },
        { { 3189.0532F, 1427.9913F, 93.55876F }, { 307.64728F, 140.79182F, 102.671555F }, { -114.66155F }, { 607.15155F, 218.06238F, -889.7109F, -530.80756F } },
        { { -651.0097F, -824.03076F, -843.65515F }, { -503.70505F, 183.63109F, -201.792F }, { 1598.665F }, { 630.6199F, -580.13525F, 246.94435F, -280.55392F } },
        { { -2019.7556F, 2970.6025F, 239.67577F }, { 903.8069F, -502.52078F, -207.64941F }, { -1484.8342F }, { -420.8136F, 778.12744F, 777.295F, -885.7982F } },
        { { 2974.687F, 2815.4238F, 2625.829F }, { -768.69836F, -947.5153F, -423.91177F }, { 345.17017F }, { 895.37775F, 574.8383F, 947.36975F, 510.02332F } },
        { { -3266.3284F, 1004.59235F, -452.93127F }, { -132.80702F, 308.41006F, 273.30115F }, { -1902.8536F }, { 1264.0792F, 18.084955F, -978.24133F, -379.42007F } },
        { { 2248.3076F, 2975.213F, 2144.8103F }, { 237.96571F, 71.76655F, 4.7469373F }, { -401.76364F }, { 1474.5117F, 648.7085F, -142.79253F, -909.49884F } },
        { { 432.22067F, -775.80524F, 3008.0586F }, { -274.3287F, -748.823F, -414.16226F }, { -727.34265F }, { -956.4581F, -417.0187F, 697.0927F, 538.39374F } },
        { { -2189.4749F, 2124.676F, 2215.7544F }, { -15.3515005F, 859.64276F, 236.60577F }, { 481.254F }, { 1626.9363F, 577.12756F, 1020.1624F, 179.60632F } },
        { { 993.95764F, 2362.6963F, 220.9935F }, { 231.15662F, 716.7821F, 74.21193F }, { -919.0781F }, { 263.2177F, 553.9841F, 483.69666F, 558.7621F } },
        { { -1285.3729F, 855.3808F, -2273.312F }, { 330.66254F, 124.861244F, 275.73312F }, { -903.1916F }, { -1891.3959F, -637.3441F, 492.1602F, -849.11566F } },
        { { -695.0472F, 2036.5597F, -223.90262F }, { -886.71924F, -196.48853F, -73.71801F }, { -1345.6724F }, { -1773.683F, -98.96331F, 83.95998F, 318.0533F } },
    };
    static const uint16_t actions[16] = {
        1U, 0U, 7U, 6U, 2U, 0U, 7U, 7U, 0U, 7U, 7U, 0U, 6U, 0U, 1U, 7U
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (widowx_rs_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
