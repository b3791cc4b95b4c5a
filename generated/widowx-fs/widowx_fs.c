/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_fs --profile fast
 * Graph SHA-256: 2460e91fcad64a969f9a7c8ed86478a4fcbac7ae14ca0273944e1ca3551f08ee
 * 31 teams (18 on the longest walk), 188 edges, 153 programs, 52 distinct operations.
 * Computes in f32 with own maths.
 */
#include "widowx_fs.h"

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

static float widowx_fs_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float widowx_fs_min(float a, float b)
{
    return (a < b) ? a : b;
}

static float widowx_fs_max(float a, float b)
{
    return (a > b) ? a : b;
}

static uint32_t widowx_fs_team_0(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    vertex = (107.35707F >= best) ? 1U : vertex;
    best = (107.35707F > best) ? 107.35707F : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v8 = 0.0F - state->polar[1];
    vertex = (v8 >= best) ? 2U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v12 = v4 / 0.0F;
    const float v13 = v12 / 0.0F;
    vertex = (v13 >= best) ? 35U : vertex;
    best = (v13 > best) ? v13 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_1(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 4U;
    vertex = (1.6245565F >= best) ? 3U : vertex;
    best = (1.6245565F > best) ? 1.6245565F : best;
    const float v15 = 0.0F * state->polar[2];
    vertex = (v15 >= best) ? 31U : vertex;
    best = (v15 > best) ? v15 : best;
    const float v16 = widowx_fs_negate_if_less(state->polar[0], 0.0F);
    vertex = (v16 >= best) ? 31U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v8 = 0.0F - state->polar[1];
    vertex = (v8 >= best) ? 2U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v20 = state->polar[1] * (-176.74728F);
    const float v22 = v20 + (-0.52844894F);
    vertex = (v22 >= best) ? 4U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_9(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 35U;
    const float v20 = state->polar[1] * (-176.74728F);
    const float v22 = v20 + (-0.52844894F);
    vertex = (v22 >= best) ? 5U : vertex;
    best = (v22 > best) ? v22 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    vertex = (20.1483F >= best) ? 6U : vertex;
    best = (20.1483F > best) ? 20.1483F : best;
    const float v23 = state->polar[2] + v4;
    vertex = (v23 >= best) ? 35U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_7(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 35U;
    const float v32 = 0.7582224F * state->polar[0];
    vertex = (v32 >= best) ? 31U : vertex;
    best = (v32 > best) ? v32 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v34 = 42.029076F / state->polar[1];
    vertex = (v34 >= best) ? 34U : vertex;
    best = (v34 > best) ? v34 : best;
    const float v20 = state->polar[1] * (-176.74728F);
    const float v22 = v20 + (-0.52844894F);
    vertex = (v22 >= best) ? 4U : vertex;
    best = (v22 > best) ? v22 : best;
    vertex = (3.135279F >= best) ? 7U : vertex;
    best = (3.135279F > best) ? 3.135279F : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    const float v12 = v4 / 0.0F;
    vertex = (v12 >= best) ? 35U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_10(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const float v20 = state->polar[1] * (-176.74728F);
    const float v22 = v20 + (-0.52844894F);
    vertex = (v22 >= best) ? 5U : vertex;
    best = (v22 > best) ? v22 : best;
    const float v46 = (-107.57004F) / state->polar[2];
    vertex = (v46 >= best) ? 8U : vertex;
    best = (v46 > best) ? v46 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v47 = 0.0F / state->polar[1];
    vertex = (v47 >= best) ? 32U : vertex;
    best = (v47 > best) ? v47 : best;
    vertex = (20.1483F >= best) ? 6U : vertex;
    best = (20.1483F > best) ? 20.1483F : best;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_12(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 7U;
    const float v49 = (-117.26495F) - state->polar[2];
    vertex = (v49 >= best) ? 9U : vertex;
    best = (v49 > best) ? v49 : best;
    const float v50 = state->polar[0] + (-117.26495F);
    vertex = (v50 >= best) ? 35U : vertex;
    best = (v50 > best) ? v50 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 10U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    vertex = (26.139645F >= best) ? 7U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_11(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v52 = state->polar[2] - 0.75724316F;
    vertex = (v52 >= best) ? 35U : vertex;
    best = (v52 > best) ? v52 : best;
    const float v43 = state->polar[2] + (-117.26495F);
    vertex = (v43 >= best) ? 35U : vertex;
    best = (v43 > best) ? v43 : best;
    vertex = (1.6245565F >= best) ? 11U : vertex;
    best = (1.6245565F > best) ? 1.6245565F : best;
    const float v54 = state->polar[0] - 0.7258825F;
    vertex = (v54 >= best) ? 31U : vertex;
    best = (v54 > best) ? v54 : best;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 12U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_13(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 12U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    vertex = (1.6245565F >= best) ? 13U : vertex;
    best = (1.6245565F > best) ? 1.6245565F : best;
    const float v27 = state->polar[1] / state->polar[1];
    vertex = (v27 >= best) ? 14U : vertex;
    best = (v27 > best) ? v27 : best;
    const float v28 = widowx_fs_max(0.0F, state->polar[0]);
    const float v29 = state->polar[1] - v28;
    vertex = (v29 >= best) ? 34U : vertex;
    best = (v29 > best) ? v29 : best;
    const float v31 = state->polar[0] - 1.0168722F;
    vertex = (v31 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_23(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 17U;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v69 = widowx_fs_negate_if_less(state->polar[1], 229.17769F);
    vertex = (v69 >= best) ? 15U : vertex;
    best = (v69 > best) ? v69 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 16U : vertex;
    best = (zero > best) ? zero : best;
    const float v70 = state->polar[1] * (-107.57004F);
    vertex = (v70 >= best) ? 17U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_20(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    vertex = (10.629795F >= best) ? 15U : vertex;
    best = (10.629795F > best) ? 10.629795F : best;
    const float v80 = widowx_fs_min(state->polar[2], 110.01199F);
    vertex = (v80 >= best) ? 18U : vertex;
    best = (v80 > best) ? v80 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 19U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_36(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 34U;
    vertex = (2.5843248F >= best) ? 14U : vertex;
    best = (2.5843248F > best) ? 2.5843248F : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    vertex = (state->polar[1] >= best) ? 34U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_15(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 20U;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 8U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    const float v61 = widowx_fs_max(state->polar[2], v4);
    vertex = (v61 >= best) ? 35U : vertex;
    best = (v61 > best) ? v61 : best;
    vertex = (v4 >= best) ? 33U : vertex;
    best = (v4 > best) ? v4 : best;
    vertex = (INFINITY >= best) ? 20U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_30(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v64 = state->polar[0] - 0.6354382F;
    vertex = (v64 >= best) ? 31U : vertex;
    best = (v64 > best) ? v64 : best;
    const float v65 = state->polar[0] + (-5.963282F);
    vertex = (v65 >= best) ? 35U : vertex;
    best = (v65 > best) ? v65 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 21U : vertex;
    best = (zero > best) ? zero : best;
    const float v41 = state->polar[2] * (-176.74728F);
    vertex = (v41 >= best) ? 22U : vertex;
    best = (v41 > best) ? v41 : best;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 19U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_14(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 11U;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 12U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v55 = state->polar[1] / 0.0F;
    vertex = (v55 >= best) ? 16U : vertex;
    best = (v55 > best) ? v55 : best;
    vertex = (1.6245565F >= best) ? 11U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_39(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 36U;
    const float v58 = widowx_fs_max(state->polar[1], 0.0F);
    const float v59 = fabsf(v58);
    vertex = (v59 >= best) ? 37U : vertex;
    best = (v59 > best) ? v59 : best;
    const float v60 = widowx_fs_min(state->polar[0], state->polar[1]);
    vertex = (v60 >= best) ? 31U : vertex;
    best = (v60 > best) ? v60 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 36U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_38(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 19U;
    const float v40 = state->polar[0] / 0.6354382F;
    vertex = (v40 >= best) ? 31U : vertex;
    best = (v40 > best) ? v40 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v41 = state->polar[2] * (-176.74728F);
    const float v42 = v41 / state->polar[1];
    vertex = (v42 >= best) ? 22U : vertex;
    best = (v42 > best) ? v42 : best;
    vertex = (2.5843248F >= best) ? 14U : vertex;
    best = (2.5843248F > best) ? 2.5843248F : best;
    const float v43 = state->polar[2] + (-117.26495F);
    vertex = (v43 >= best) ? 32U : vertex;
    best = (v43 > best) ? v43 : best;
    vertex = (state->polar[0] >= best) ? 31U : vertex;
    best = (state->polar[0] > best) ? state->polar[0] : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 19U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_24(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 23U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v69 = widowx_fs_negate_if_less(state->polar[1], 229.17769F);
    vertex = (v69 >= best) ? 15U : vertex;
    best = (v69 > best) ? v69 : best;
    const float v43 = state->polar[2] + (-117.26495F);
    vertex = (v43 >= best) ? 32U : vertex;
    best = (v43 > best) ? v43 : best;
    const float v28 = widowx_fs_max(0.0F, state->polar[0]);
    const float v29 = state->polar[1] - v28;
    vertex = (v29 >= best) ? 34U : vertex;
    best = (v29 > best) ? v29 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 19U : vertex;
    best = (v48 > best) ? v48 : best;
    vertex = (10.629795F >= best) ? 15U : vertex;
    best = (10.629795F > best) ? 10.629795F : best;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_37(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 34U;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v64 = state->polar[0] - 0.6354382F;
    vertex = (v64 >= best) ? 31U : vertex;
    best = (v64 > best) ? v64 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 19U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v43 = state->polar[2] + (-117.26495F);
    vertex = (v43 >= best) ? 32U : vertex;
    best = (v43 > best) ? v43 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 34U : vertex;
    best = (zero > best) ? zero : best;
    const float v72 = state->polar[0] * 0.87870044F;
    vertex = (v72 >= best) ? 22U : vertex;
    best = (v72 > best) ? v72 : best;
    const float v28 = widowx_fs_max(0.0F, state->polar[0]);
    const float v29 = state->polar[1] - v28;
    vertex = (v29 >= best) ? 34U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_21(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 19U;
    const float v85 = widowx_fs_negate_if_less(state->polar[1], (-1.1606317F));
    vertex = (v85 >= best) ? 24U : vertex;
    best = (v85 > best) ? v85 : best;
    vertex = (15.754999F >= best) ? 25U : vertex;
    best = (15.754999F > best) ? 15.754999F : best;
    const float v70 = state->polar[1] * (-107.57004F);
    vertex = (v70 >= best) ? 17U : vertex;
    best = (v70 > best) ? v70 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 19U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_42(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const float v47 = 0.0F / state->polar[1];
    vertex = (v47 >= best) ? 32U : vertex;
    best = (v47 > best) ? v47 : best;
    vertex = (state->polar[0] >= best) ? 31U : vertex;
    best = (state->polar[0] > best) ? state->polar[0] : best;
    const float v7 = widowx_fs_min((-8.893463F), state->polar[1]);
    vertex = (v7 >= best) ? 31U : vertex;
    best = (v7 > best) ? v7 : best;
    vertex = (state->polar[1] >= best) ? 34U : vertex;
    best = (state->polar[1] > best) ? state->polar[1] : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_17(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v57 = state->polar[2] - (-6.7057414F);
    vertex = (v57 >= best) ? 33U : vertex;
    best = (v57 > best) ? v57 : best;
    vertex = (6.543999F >= best) ? 38U : vertex;
    best = (6.543999F > best) ? 6.543999F : best;
    const float v55 = state->polar[1] / 0.0F;
    vertex = (v55 >= best) ? 16U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 19U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 33U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_31(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 19U;
    const float v82 = 0.0F - state->polar[0];
    const float v83 = 2.710111F / v82;
    vertex = (v83 >= best) ? 32U : vertex;
    best = (v83 > best) ? v83 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 31U : vertex;
    best = (zero > best) ? zero : best;
    const float v27 = state->polar[1] / state->polar[1];
    vertex = (v27 >= best) ? 14U : vertex;
    best = (v27 > best) ? v27 : best;
    const float v41 = state->polar[2] * (-176.74728F);
    const float v42 = v41 / state->polar[1];
    vertex = (v42 >= best) ? 22U : vertex;
    best = (v42 > best) ? v42 : best;
    const float v64 = state->polar[0] - 0.6354382F;
    vertex = (v64 >= best) ? 26U : vertex;
    best = (v64 > best) ? v64 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 19U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_41(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 34U : vertex;
    best = (zero > best) ? zero : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v67 = state->polar[1] * (-55.687565F);
    vertex = (v67 >= best) ? 36U : vertex;
    best = (v67 > best) ? v67 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_27(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 12U;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 19U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v86 = (-79.08088F) - state->polar[0];
    vertex = (v86 >= best) ? 27U : vertex;
    best = (v86 > best) ? v86 : best;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v47 = 0.0F / state->polar[1];
    vertex = (v47 >= best) ? 32U : vertex;
    best = (v47 > best) ? v47 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 28U : vertex;
    best = (v4 > best) ? v4 : best;
    vertex = (13.937786F >= best) ? 15U : vertex;
    best = (13.937786F > best) ? 13.937786F : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 12U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_22(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 19U;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 19U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    vertex = (15.754999F >= best) ? 25U : vertex;
    best = (15.754999F > best) ? 15.754999F : best;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v43 = state->polar[2] + (-117.26495F);
    vertex = (v43 >= best) ? 32U : vertex;
    best = (v43 > best) ? v43 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 19U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_32(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const float v72 = state->polar[0] * 0.87870044F;
    vertex = (v72 >= best) ? 31U : vertex;
    best = (v72 > best) ? v72 : best;
    const float v73 = state->polar[2] * state->polar[0];
    const float v74 = v73 - state->polar[0];
    const float v75 = 2.710111F / v74;
    vertex = (v75 >= best) ? 32U : vertex;
    best = (v75 > best) ? v75 : best;
    const float v76 = state->polar[0] + (-107.57004F);
    vertex = (v76 >= best) ? 32U : vertex;
    best = (v76 > best) ? v76 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 34U : vertex;
    best = (zero > best) ? zero : best;
    const float v27 = state->polar[1] / state->polar[1];
    vertex = (v27 >= best) ? 14U : vertex;
    best = (v27 > best) ? v27 : best;
    const float v41 = state->polar[2] * (-176.74728F);
    const float v42 = v41 / state->polar[1];
    vertex = (v42 >= best) ? 22U : vertex;
    best = (v42 > best) ? v42 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 14U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v64 = state->polar[0] - 0.6354382F;
    vertex = (v64 >= best) ? 26U : vertex;
    best = (v64 > best) ? v64 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v78 = state->polar[0] * 0.18706028F;
    vertex = (v78 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_34(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 32U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v64 = state->polar[0] - 0.6354382F;
    vertex = (v64 >= best) ? 31U : vertex;
    best = (v64 > best) ? v64 : best;
    vertex = (15.754999F >= best) ? 29U : vertex;
    best = (15.754999F > best) ? 15.754999F : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 19U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v43 = state->polar[2] + (-117.26495F);
    vertex = (v43 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_40(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    vertex = (state->polar[2] >= best) ? 31U : vertex;
    best = (state->polar[2] > best) ? state->polar[2] : best;
    vertex = (10.629795F >= best) ? 22U : vertex;
    best = (10.629795F > best) ? 10.629795F : best;
    const float v28 = widowx_fs_max(0.0F, state->polar[0]);
    const float v29 = state->polar[1] - v28;
    vertex = (v29 >= best) ? 34U : vertex;
    best = (v29 > best) ? v29 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_28(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 19U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 35U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v70 = state->polar[1] * (-107.57004F);
    vertex = (v70 >= best) ? 17U : vertex;
    best = (v70 > best) ? v70 : best;
    const float v64 = state->polar[0] - 0.6354382F;
    vertex = (v64 >= best) ? 30U : vertex;
    best = (v64 > best) ? v64 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 27U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v82 = 0.0F - state->polar[0];
    const float v83 = 2.710111F / v82;
    vertex = (v83 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_35(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    vertex = (83.54613F >= best) ? 22U : vertex;
    best = (83.54613F > best) ? 83.54613F : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v73 = state->polar[2] * state->polar[0];
    const float v74 = v73 - state->polar[0];
    const float v75 = 2.710111F / v74;
    vertex = (v75 >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_29(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 17U;
    const float v48 = (-107.57004F) / state->polar[0];
    vertex = (v48 >= best) ? 19U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v4 = state->polar[2] - 0.7582224F;
    vertex = (v4 >= best) ? 31U : vertex;
    best = (v4 > best) ? v4 : best;
    vertex = (10.629795F >= best) ? 15U : vertex;
    best = (10.629795F > best) ? 10.629795F : best;
    const float v45 = state->polar[0] * (-79.08088F);
    vertex = (v45 >= best) ? 35U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v10 = state->polar[0] - 0.7582224F;
    vertex = (v10 >= best) ? 31U : vertex;
    best = (v10 > best) ? v10 : best;
    const float v18 = state->polar[0] * (-107.57004F);
    vertex = (v18 >= best) ? 12U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v70 = state->polar[1] * (-107.57004F);
    vertex = (v70 >= best) ? 17U : vertex;
    return vertex;
}

/* Teams are numbered from 0, which is the root; the actions follow them. */
uint16_t widowx_fs_infer(const widowx_fs_state_t *state)
{
    uint32_t vertex = 0U;
    uint32_t hop;

    for (hop = 0U; (hop < WIDOWX_FS_DEPTH) && (vertex < WIDOWX_FS_TEAMS); hop++) {
        switch (vertex) {
        case 0U:
            vertex = widowx_fs_team_0(state);
            break;
        case 1U:
            vertex = widowx_fs_team_1(state);
            break;
        case 2U:
            vertex = widowx_fs_team_9(state);
            break;
        case 3U:
            vertex = widowx_fs_team_7(state);
            break;
        case 4U:
            vertex = widowx_fs_team_10(state);
            break;
        case 5U:
            vertex = widowx_fs_team_12(state);
            break;
        case 6U:
            vertex = widowx_fs_team_11(state);
            break;
        case 7U:
            vertex = widowx_fs_team_13(state);
            break;
        case 8U:
            vertex = widowx_fs_team_23(state);
            break;
        case 9U:
            vertex = widowx_fs_team_20(state);
            break;
        case 10U:
            vertex = widowx_fs_team_36(state);
            break;
        case 11U:
            vertex = widowx_fs_team_15(state);
            break;
        case 12U:
            vertex = widowx_fs_team_30(state);
            break;
        case 13U:
            vertex = widowx_fs_team_14(state);
            break;
        case 14U:
            vertex = widowx_fs_team_39(state);
            break;
        case 15U:
            vertex = widowx_fs_team_38(state);
            break;
        case 16U:
            vertex = widowx_fs_team_24(state);
            break;
        case 17U:
            vertex = widowx_fs_team_37(state);
            break;
        case 18U:
            vertex = widowx_fs_team_21(state);
            break;
        case 19U:
            vertex = widowx_fs_team_42(state);
            break;
        case 20U:
            vertex = widowx_fs_team_17(state);
            break;
        case 21U:
            vertex = widowx_fs_team_31(state);
            break;
        case 22U:
            vertex = widowx_fs_team_41(state);
            break;
        case 23U:
            vertex = widowx_fs_team_27(state);
            break;
        case 24U:
            vertex = widowx_fs_team_22(state);
            break;
        case 25U:
            vertex = widowx_fs_team_32(state);
            break;
        case 26U:
            vertex = widowx_fs_team_34(state);
            break;
        case 27U:
            vertex = widowx_fs_team_40(state);
            break;
        case 28U:
            vertex = widowx_fs_team_28(state);
            break;
        case 29U:
            vertex = widowx_fs_team_35(state);
            break;
        case 30U:
            vertex = widowx_fs_team_29(state);
            break;
        default:
            vertex = WIDOWX_FS_TEAMS; /* never: every team has its case */
            break;
        }
    }
    vertex -= WIDOWX_FS_TEAMS;
    return (uint16_t)vertex;
}
#ifndef WIDOWX_FS_NO_SELFTEST

uint32_t widowx_fs_selftest(void)
{
    static const widowx_fs_state_t states[16] = {
        { { -87.56787F, -376.81543F, 86.711044F } },
        { { -252.04652F, -194.24585F, 189.12798F } },
        { { -34.94282F, -311.91788F, 336.5534F } },
        { { 185.54842F, -15.035073F, 69.33381F } },
        { { -359.68533F, -212.00203F, -41.793167F } },
        { { -197.3546F, 440.94708F, 370.29474F } },
        { { 401.5115F, -329.34695F, -140.37167F } },
        { { -17.688581F, -92.19368F, -436.69962F } },
        { { -405.07013F, -282.7537F, 22.921425F } },
        { { -208.21704F, -369.602F, -358.79178F } },
        { { 440.93307F, 175.10577F, -351.7956F } },
        { { 71.54548F, 207.21135F, 183.77618F } },
        { { -248.36806F, 406.9167F, -333.8488F } },
        { { 119.005394F, 272.89218F, 73.04839F } },
        { { 358.8477F, -108.382034F, -20.80021F } },
        { { 379.1257F, -144.98795F, 112.98503F } },
    };
    static const uint16_t actions[16] = {
        4U, 4U, 4U, 4U, 1U, 4U, 0U, 1U, 4U, 1U, 0U, 4U, 1U, 4U, 0U, 4U
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (widowx_fs_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
