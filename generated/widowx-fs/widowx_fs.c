/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_fs --profile fast
 * Graph SHA-256: 36990850ec2e9a46699110a4764611e2bc47067713cc9af0e6e5503f1e975f93
 * 28 teams (16 on the longest walk), 174 edges, 141 programs, 49 distinct operations.
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
    uint32_t vertex = 35U;
    const float v2 = state->polar[0] * 0.7582224F;
    vertex = (v2 >= best) ? 28U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v10 = state->polar[1] * (-99.097435F);
    const float v12 = v10 + (-0.52844894F);
    vertex = (v12 >= best) ? 1U : vertex;
    best = (v12 > best) ? v12 : best;
    vertex = (3.135279F >= best) ? 2U : vertex;
    best = (3.135279F > best) ? 3.135279F : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    const float v18 = v16 / 0.0F;
    vertex = (v18 >= best) ? 32U : vertex;
    best = (v18 > best) ? v18 : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v7 = 42.029076F / state->polar[1];
    vertex = (v7 >= best) ? 31U : vertex;
    best = (v7 > best) ? v7 : best;
    const float v21 = (-107.57004F) / state->polar[2];
    vertex = (v21 >= best) ? 35U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_1(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v29 = state->polar[1] * (-176.74728F);
    const float v30 = (-0.52844894F) + v29;
    vertex = (v30 >= best) ? 3U : vertex;
    best = (v30 > best) ? v30 : best;
    const float v21 = (-107.57004F) / state->polar[2];
    vertex = (v21 >= best) ? 4U : vertex;
    best = (v21 > best) ? v21 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 32U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v31 = 0.0F / state->polar[1];
    vertex = (v31 >= best) ? 29U : vertex;
    best = (v31 > best) ? v31 : best;
    vertex = (20.1483F >= best) ? 5U : vertex;
    best = (20.1483F > best) ? 20.1483F : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_4(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 32U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 6U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    vertex = (1.6245565F >= best) ? 7U : vertex;
    best = (1.6245565F > best) ? 1.6245565F : best;
    const float v23 = state->polar[1] / state->polar[1];
    vertex = (v23 >= best) ? 8U : vertex;
    best = (v23 > best) ? v23 : best;
    const float v24 = widowx_fs_max(0.0F, state->polar[0]);
    const float v25 = state->polar[1] - v24;
    vertex = (v25 >= best) ? 31U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v27 = state->polar[0] - 1.0168722F;
    vertex = (v27 >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_3(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 2U;
    const float v53 = (-117.26495F) - state->polar[2];
    vertex = (v53 >= best) ? 9U : vertex;
    best = (v53 > best) ? v53 : best;
    const float v54 = state->polar[0] + (-117.26495F);
    vertex = (v54 >= best) ? 32U : vertex;
    best = (v54 > best) ? v54 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 10U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 32U : vertex;
    best = (v16 > best) ? v16 : best;
    vertex = (26.139645F >= best) ? 2U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_14(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 13U;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 32U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v56 = widowx_fs_negate_if_less(state->polar[1], 229.17769F);
    vertex = (v56 >= best) ? 11U : vertex;
    best = (v56 > best) ? v56 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 12U : vertex;
    best = (zero > best) ? zero : best;
    const float v57 = (-107.57004F) * state->polar[1];
    vertex = (v57 >= best) ? 13U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_2(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 32U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v59 = state->polar[2] - 0.75724316F;
    vertex = (v59 >= best) ? 32U : vertex;
    best = (v59 > best) ? v59 : best;
    const float v60 = state->polar[2] + (-117.26495F);
    vertex = (v60 >= best) ? 32U : vertex;
    best = (v60 > best) ? v60 : best;
    vertex = (1.6245565F >= best) ? 14U : vertex;
    best = (1.6245565F > best) ? 1.6245565F : best;
    const float v62 = state->polar[0] - 0.7258825F;
    vertex = (v62 >= best) ? 28U : vertex;
    best = (v62 > best) ? v62 : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 6U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_21(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v45 = state->polar[0] - 0.6354382F;
    vertex = (v45 >= best) ? 28U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v47 = state->polar[0] + (-5.963282F);
    vertex = (v47 >= best) ? 32U : vertex;
    best = (v47 > best) ? v47 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 15U : vertex;
    best = (zero > best) ? zero : best;
    const float v48 = state->polar[2] * (-176.74728F);
    vertex = (v48 >= best) ? 16U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 17U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_5(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 14U;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 32U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 6U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v37 = state->polar[1] / 0.0F;
    vertex = (v37 >= best) ? 12U : vertex;
    best = (v37 > best) ? v37 : best;
    vertex = (1.6245565F >= best) ? 14U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_30(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 33U;
    const float v49 = widowx_fs_max(state->polar[1], 0.0F);
    const float v50 = fabsf(v49);
    vertex = (v50 >= best) ? 34U : vertex;
    best = (v50 > best) ? v50 : best;
    const float v51 = widowx_fs_min(state->polar[0], state->polar[1]);
    vertex = (v51 >= best) ? 28U : vertex;
    best = (v51 > best) ? v51 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 33U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_11(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    vertex = (10.629795F >= best) ? 11U : vertex;
    best = (10.629795F > best) ? 10.629795F : best;
    const float v64 = widowx_fs_min(state->polar[2], 110.01199F);
    vertex = (v64 >= best) ? 18U : vertex;
    best = (v64 > best) ? v64 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 17U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_27(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    vertex = (2.5843248F >= best) ? 8U : vertex;
    best = (2.5843248F > best) ? 2.5843248F : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    vertex = (state->polar[1] >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_29(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 17U;
    const float v72 = state->polar[0] / 0.6354382F;
    vertex = (v72 >= best) ? 28U : vertex;
    best = (v72 > best) ? v72 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v48 = state->polar[2] * (-176.74728F);
    const float v70 = v48 / state->polar[1];
    vertex = (v70 >= best) ? 16U : vertex;
    best = (v70 > best) ? v70 : best;
    vertex = (2.5843248F >= best) ? 8U : vertex;
    best = (2.5843248F > best) ? 2.5843248F : best;
    const float v60 = state->polar[2] + (-117.26495F);
    vertex = (v60 >= best) ? 29U : vertex;
    best = (v60 > best) ? v60 : best;
    vertex = (state->polar[0] >= best) ? 28U : vertex;
    best = (state->polar[0] > best) ? state->polar[0] : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 17U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_15(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 19U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v56 = widowx_fs_negate_if_less(state->polar[1], 229.17769F);
    vertex = (v56 >= best) ? 11U : vertex;
    best = (v56 > best) ? v56 : best;
    const float v60 = state->polar[2] + (-117.26495F);
    vertex = (v60 >= best) ? 29U : vertex;
    best = (v60 > best) ? v60 : best;
    const float v24 = widowx_fs_max(0.0F, state->polar[0]);
    const float v25 = state->polar[1] - v24;
    vertex = (v25 >= best) ? 31U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 17U : vertex;
    best = (v38 > best) ? v38 : best;
    vertex = (10.629795F >= best) ? 11U : vertex;
    best = (10.629795F > best) ? 10.629795F : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_28(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v45 = state->polar[0] - 0.6354382F;
    vertex = (v45 >= best) ? 28U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 17U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v60 = state->polar[2] + (-117.26495F);
    vertex = (v60 >= best) ? 29U : vertex;
    best = (v60 > best) ? v60 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 31U : vertex;
    best = (zero > best) ? zero : best;
    const float v74 = state->polar[0] * 0.87870044F;
    vertex = (v74 >= best) ? 16U : vertex;
    best = (v74 > best) ? v74 : best;
    const float v24 = widowx_fs_max(0.0F, state->polar[0]);
    const float v25 = state->polar[1] - v24;
    vertex = (v25 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_6(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 20U;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 4U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    const float v41 = widowx_fs_max(state->polar[2], v16);
    vertex = (v41 >= best) ? 32U : vertex;
    best = (v41 > best) ? v41 : best;
    vertex = (v16 >= best) ? 30U : vertex;
    best = (v16 > best) ? v16 : best;
    vertex = (INFINITY >= best) ? 20U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_22(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 17U;
    const float v68 = 0.0F - state->polar[0];
    const float v69 = 2.710111F / v68;
    vertex = (v69 >= best) ? 29U : vertex;
    best = (v69 > best) ? v69 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 28U : vertex;
    best = (zero > best) ? zero : best;
    const float v23 = state->polar[1] / state->polar[1];
    vertex = (v23 >= best) ? 8U : vertex;
    best = (v23 > best) ? v23 : best;
    const float v48 = state->polar[2] * (-176.74728F);
    const float v70 = v48 / state->polar[1];
    vertex = (v70 >= best) ? 16U : vertex;
    best = (v70 > best) ? v70 : best;
    const float v45 = state->polar[0] - 0.6354382F;
    vertex = (v45 >= best) ? 21U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 17U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_32(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 31U : vertex;
    best = (zero > best) ? zero : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v35 = state->polar[1] * (-55.687565F);
    vertex = (v35 >= best) ? 33U : vertex;
    best = (v35 > best) ? v35 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_33(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v31 = 0.0F / state->polar[1];
    vertex = (v31 >= best) ? 29U : vertex;
    best = (v31 > best) ? v31 : best;
    vertex = (state->polar[0] >= best) ? 28U : vertex;
    best = (state->polar[0] > best) ? state->polar[0] : best;
    const float v66 = widowx_fs_min((-8.893463F), state->polar[1]);
    vertex = (v66 >= best) ? 28U : vertex;
    best = (v66 > best) ? v66 : best;
    vertex = (state->polar[1] >= best) ? 31U : vertex;
    best = (state->polar[1] > best) ? state->polar[1] : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_12(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 17U;
    const float v81 = widowx_fs_negate_if_less(state->polar[1], (-1.1606317F));
    vertex = (v81 >= best) ? 22U : vertex;
    best = (v81 > best) ? v81 : best;
    vertex = (15.754999F >= best) ? 23U : vertex;
    best = (15.754999F > best) ? 15.754999F : best;
    const float v57 = (-107.57004F) * state->polar[1];
    vertex = (v57 >= best) ? 13U : vertex;
    best = (v57 > best) ? v57 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 17U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_18(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 6U;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 17U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v75 = (-79.08088F) - state->polar[0];
    vertex = (v75 >= best) ? 24U : vertex;
    best = (v75 > best) ? v75 : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v31 = 0.0F / state->polar[1];
    vertex = (v31 >= best) ? 29U : vertex;
    best = (v31 > best) ? v31 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 25U : vertex;
    best = (v16 > best) ? v16 : best;
    vertex = (13.937786F >= best) ? 11U : vertex;
    best = (13.937786F > best) ? 13.937786F : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 6U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_8(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    const float v40 = state->polar[2] - (-6.7057414F);
    vertex = (v40 >= best) ? 30U : vertex;
    best = (v40 > best) ? v40 : best;
    vertex = (6.543999F >= best) ? 35U : vertex;
    best = (6.543999F > best) ? 6.543999F : best;
    const float v37 = state->polar[1] / 0.0F;
    vertex = (v37 >= best) ? 12U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 17U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 30U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_25(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v45 = state->polar[0] - 0.6354382F;
    vertex = (v45 >= best) ? 28U : vertex;
    best = (v45 > best) ? v45 : best;
    vertex = (15.754999F >= best) ? 26U : vertex;
    best = (15.754999F > best) ? 15.754999F : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 17U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v60 = state->polar[2] + (-117.26495F);
    vertex = (v60 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_13(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 17U;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 17U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    vertex = (15.754999F >= best) ? 23U : vertex;
    best = (15.754999F > best) ? 15.754999F : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 29U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v60 = state->polar[2] + (-117.26495F);
    vertex = (v60 >= best) ? 29U : vertex;
    best = (v60 > best) ? v60 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 17U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_23(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v74 = state->polar[0] * 0.87870044F;
    vertex = (v74 >= best) ? 28U : vertex;
    best = (v74 > best) ? v74 : best;
    const float v77 = state->polar[0] * state->polar[2];
    const float v78 = v77 - state->polar[0];
    const float v79 = 2.710111F / v78;
    vertex = (v79 >= best) ? 29U : vertex;
    best = (v79 > best) ? v79 : best;
    const float v82 = state->polar[0] + (-107.57004F);
    vertex = (v82 >= best) ? 29U : vertex;
    best = (v82 > best) ? v82 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 31U : vertex;
    best = (zero > best) ? zero : best;
    const float v23 = state->polar[1] / state->polar[1];
    vertex = (v23 >= best) ? 8U : vertex;
    best = (v23 > best) ? v23 : best;
    const float v48 = state->polar[2] * (-176.74728F);
    const float v70 = v48 / state->polar[1];
    vertex = (v70 >= best) ? 16U : vertex;
    best = (v70 > best) ? v70 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 8U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v45 = state->polar[0] - 0.6354382F;
    vertex = (v45 >= best) ? 21U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v84 = state->polar[0] * 0.18706028F;
    vertex = (v84 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_31(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 28U;
    vertex = (state->polar[2] >= best) ? 28U : vertex;
    best = (state->polar[2] > best) ? state->polar[2] : best;
    vertex = (10.629795F >= best) ? 16U : vertex;
    best = (10.629795F > best) ? 10.629795F : best;
    const float v24 = widowx_fs_max(0.0F, state->polar[0]);
    const float v25 = state->polar[1] - v24;
    vertex = (v25 >= best) ? 31U : vertex;
    best = (v25 > best) ? v25 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_19(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 17U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 32U : vertex;
    best = (v16 > best) ? v16 : best;
    const float v57 = (-107.57004F) * state->polar[1];
    vertex = (v57 >= best) ? 13U : vertex;
    best = (v57 > best) ? v57 : best;
    const float v45 = state->polar[0] - 0.6354382F;
    vertex = (v45 >= best) ? 27U : vertex;
    best = (v45 > best) ? v45 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 24U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v68 = 0.0F - state->polar[0];
    const float v69 = 2.710111F / v68;
    vertex = (v69 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_26(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 29U;
    vertex = (83.54613F >= best) ? 16U : vertex;
    best = (83.54613F > best) ? 83.54613F : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 29U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v77 = state->polar[0] * state->polar[2];
    const float v78 = v77 - state->polar[0];
    const float v79 = 2.710111F / v78;
    vertex = (v79 >= best) ? 29U : vertex;
    return vertex;
}

static uint32_t widowx_fs_team_20(const widowx_fs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 13U;
    const float v38 = (-107.57004F) / state->polar[0];
    vertex = (v38 >= best) ? 17U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v16 = state->polar[2] - 0.7582224F;
    vertex = (v16 >= best) ? 28U : vertex;
    best = (v16 > best) ? v16 : best;
    vertex = (10.629795F >= best) ? 11U : vertex;
    best = (10.629795F > best) ? 10.629795F : best;
    const float v20 = state->polar[0] * (-79.08088F);
    vertex = (v20 >= best) ? 32U : vertex;
    best = (v20 > best) ? v20 : best;
    const float v14 = state->polar[0] - 0.7582224F;
    vertex = (v14 >= best) ? 28U : vertex;
    best = (v14 > best) ? v14 : best;
    const float v4 = state->polar[0] * (-107.57004F);
    vertex = (v4 >= best) ? 6U : vertex;
    best = (v4 > best) ? v4 : best;
    const float v57 = (-107.57004F) * state->polar[1];
    vertex = (v57 >= best) ? 13U : vertex;
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
            vertex = widowx_fs_team_4(state);
            break;
        case 3U:
            vertex = widowx_fs_team_3(state);
            break;
        case 4U:
            vertex = widowx_fs_team_14(state);
            break;
        case 5U:
            vertex = widowx_fs_team_2(state);
            break;
        case 6U:
            vertex = widowx_fs_team_21(state);
            break;
        case 7U:
            vertex = widowx_fs_team_5(state);
            break;
        case 8U:
            vertex = widowx_fs_team_30(state);
            break;
        case 9U:
            vertex = widowx_fs_team_11(state);
            break;
        case 10U:
            vertex = widowx_fs_team_27(state);
            break;
        case 11U:
            vertex = widowx_fs_team_29(state);
            break;
        case 12U:
            vertex = widowx_fs_team_15(state);
            break;
        case 13U:
            vertex = widowx_fs_team_28(state);
            break;
        case 14U:
            vertex = widowx_fs_team_6(state);
            break;
        case 15U:
            vertex = widowx_fs_team_22(state);
            break;
        case 16U:
            vertex = widowx_fs_team_32(state);
            break;
        case 17U:
            vertex = widowx_fs_team_33(state);
            break;
        case 18U:
            vertex = widowx_fs_team_12(state);
            break;
        case 19U:
            vertex = widowx_fs_team_18(state);
            break;
        case 20U:
            vertex = widowx_fs_team_8(state);
            break;
        case 21U:
            vertex = widowx_fs_team_25(state);
            break;
        case 22U:
            vertex = widowx_fs_team_13(state);
            break;
        case 23U:
            vertex = widowx_fs_team_23(state);
            break;
        case 24U:
            vertex = widowx_fs_team_31(state);
            break;
        case 25U:
            vertex = widowx_fs_team_19(state);
            break;
        case 26U:
            vertex = widowx_fs_team_26(state);
            break;
        case 27U:
            vertex = widowx_fs_team_20(state);
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
