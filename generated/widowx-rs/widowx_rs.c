/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_rs --profile fast
 * Graph SHA-256: 4c66c6b65c6c713d5ad1fe31be297b7d3fcebbf6d3d7971a9a27b9132c25b11f
 * 30 teams (16 on the longest walk), 210 edges, 156 programs, 58 distinct operations.
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
    uint32_t vertex = 32U;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 1U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v6 = state->stance[1] - 9.539528F;
    vertex = (v6 >= best) ? 2U : vertex;
    best = (v6 > best) ? v6 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 3U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v11 = 164.8815F * state->stance[3];
    vertex = (v11 >= best) ? 36U : vertex;
    best = (v11 > best) ? v11 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_7(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 6U;
    const float v24 = (-3.3748567F) - state->floor[0];
    vertex = (v24 >= best) ? 36U : vertex;
    best = (v24 > best) ? v24 : best;
    const float v6 = state->stance[1] - 9.539528F;
    vertex = (v6 >= best) ? 2U : vertex;
    best = (v6 > best) ? v6 : best;
    const float v26 = (-10.533181F) - state->floor[0];
    vertex = (v26 >= best) ? 4U : vertex;
    best = (v26 > best) ? v26 : best;
    const float v29 = 0.0F - state->floor[0];
    vertex = (v29 >= best) ? 31U : vertex;
    best = (v29 > best) ? v29 : best;
    const float v22 = widowx_rs_max((-161.71835F), state->stance[2]);
    vertex = (v22 >= best) ? 34U : vertex;
    best = (v22 > best) ? v22 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 35U : vertex;
    best = (zero > best) ? zero : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    const float v30 = v17 * state->floor[0];
    vertex = (v30 >= best) ? 31U : vertex;
    best = (v30 > best) ? v30 : best;
    const float v28 = state->stance[3] * (-6.3484564F);
    vertex = (v28 >= best) ? 5U : vertex;
    best = (v28 > best) ? v28 : best;
    const float v31 = state->stance[3] / state->floor[0];
    vertex = (v31 >= best) ? 6U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_44(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 32U;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 31U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    vertex = (state->floor[0] >= best) ? 32U : vertex;
    best = (state->floor[0] > best) ? state->floor[0] : best;
    vertex = (9.506875F >= best) ? 32U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_5(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 36U;
    const float v28 = state->stance[3] * (-6.3484564F);
    vertex = (v28 >= best) ? 5U : vertex;
    best = (v28 > best) ? v28 : best;
    const float v34 = widowx_rs_max(state->stance[2], (-3.385455F));
    vertex = (v34 >= best) ? 36U : vertex;
    best = (v34 > best) ? v34 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 1U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    const float v30 = v17 * state->floor[0];
    vertex = (v30 >= best) ? 31U : vertex;
    best = (v30 > best) ? v30 : best;
    const float v35 = (-6.3484564F) - state->stance[3];
    vertex = (v35 >= best) ? 5U : vertex;
    best = (v35 > best) ? v35 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 2U : vertex;
    best = (zero > best) ? zero : best;
    const float v24 = (-3.3748567F) - state->floor[0];
    vertex = (v24 >= best) ? 36U : vertex;
    best = (v24 > best) ? v24 : best;
    const float v11 = 164.8815F * state->stance[3];
    vertex = (v11 >= best) ? 36U : vertex;
    best = (v11 > best) ? v11 : best;
    const float v13 = state->stance[1] / 11.184899F;
    vertex = (v13 >= best) ? 36U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_11(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 37U;
    const float v13 = state->stance[1] / 11.184899F;
    vertex = (v13 >= best) ? 34U : vertex;
    best = (v13 > best) ? v13 : best;
    const float v15 = state->stance[1] / 0.0F;
    vertex = (v15 >= best) ? 6U : vertex;
    best = (v15 > best) ? v15 : best;
    const float v11 = 164.8815F * state->stance[3];
    vertex = (v11 >= best) ? 36U : vertex;
    best = (v11 > best) ? v11 : best;
    vertex = (24.873356F >= best) ? 7U : vertex;
    best = (24.873356F > best) ? 24.873356F : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 31U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v20 = 0.0F + state->stance[3];
    vertex = (v20 >= best) ? 37U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_10(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 6U;
    const float v13 = state->stance[1] / 11.184899F;
    vertex = (v13 >= best) ? 34U : vertex;
    best = (v13 > best) ? v13 : best;
    const float v63 = state->stance[1] - 9.689877F;
    vertex = (v63 >= best) ? 8U : vertex;
    best = (v63 > best) ? v63 : best;
    vertex = (24.873356F >= best) ? 7U : vertex;
    best = (24.873356F > best) ? 24.873356F : best;
    const float v43 = fabsf(state->floor[0]);
    const float v44 = state->stance[0] / v43;
    vertex = (v44 >= best) ? 30U : vertex;
    best = (v44 > best) ? v44 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 9U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v29 = 0.0F - state->floor[0];
    vertex = (v29 >= best) ? 31U : vertex;
    best = (v29 > best) ? v29 : best;
    const float v15 = state->stance[1] / 0.0F;
    vertex = (v15 >= best) ? 6U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_13(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    vertex = (22.918602F >= best) ? 10U : vertex;
    best = (22.918602F > best) ? 22.918602F : best;
    const float v48 = fabsf(state->stance[3]);
    vertex = (v48 >= best) ? 8U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v11 = 164.8815F * state->stance[3];
    vertex = (v11 >= best) ? 36U : vertex;
    best = (v11 > best) ? v11 : best;
    const float v36 = state->stance[1] + 9.539528F;
    vertex = (v36 >= best) ? 11U : vertex;
    best = (v36 > best) ? v36 : best;
    const float v50 = state->stance[0] / 11.077008F;
    vertex = (v50 >= best) ? 12U : vertex;
    best = (v50 > best) ? v50 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 13U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v43 = fabsf(state->floor[0]);
    const float v44 = state->stance[0] / v43;
    vertex = (v44 >= best) ? 14U : vertex;
    best = (v44 > best) ? v44 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 9U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v37 = widowx_rs_min(v17, state->floor[0]);
    vertex = (v37 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_12(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v11 = 164.8815F * state->stance[3];
    vertex = (v11 >= best) ? 36U : vertex;
    best = (v11 > best) ? v11 : best;
    const float v15 = state->stance[1] / 0.0F;
    vertex = (v15 >= best) ? 15U : vertex;
    best = (v15 > best) ? v15 : best;
    const float v43 = fabsf(state->floor[0]);
    const float v58 = state->stance[1] / v43;
    vertex = (v58 >= best) ? 30U : vertex;
    best = (v58 > best) ? v58 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 9U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v52 = widowx_rs_negate_if_less(state->stance[1], (-26.200392F));
    vertex = (v52 >= best) ? 33U : vertex;
    best = (v52 > best) ? v52 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    best = (v5 > best) ? v5 : best;
    vertex = (11.302588F >= best) ? 16U : vertex;
    best = (11.302588F > best) ? 11.302588F : best;
    const float v29 = 0.0F - state->floor[0];
    vertex = (v29 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_32(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 2U;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 17U : vertex;
    best = (v17 > best) ? v17 : best;
    vertex = (22.918602F >= best) ? 37U : vertex;
    best = (22.918602F > best) ? 22.918602F : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 18U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v36 = state->stance[1] + 9.539528F;
    vertex = (v36 >= best) ? 2U : vertex;
    best = (v36 > best) ? v36 : best;
    const float v57 = state->stance[3] / 15.430052F;
    vertex = (v57 >= best) ? 36U : vertex;
    best = (v57 > best) ? v57 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_45(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v52 = widowx_rs_negate_if_less(state->stance[1], (-26.200392F));
    vertex = (v52 >= best) ? 33U : vertex;
    best = (v52 > best) ? v52 : best;
    const float v53 = widowx_rs_max(state->floor[0], state->stance[1]);
    const float v54 = widowx_rs_max(v53, state->floor[0]);
    vertex = (v54 >= best) ? 31U : vertex;
    best = (v54 > best) ? v54 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v29 = 0.0F - state->floor[0];
    vertex = (v29 >= best) ? 31U : vertex;
    best = (v29 > best) ? v29 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    vertex = (4.372006F >= best) ? 31U : vertex;
    best = (4.372006F > best) ? 4.372006F : best;
    const float v55 = widowx_rs_min(state->stance[2], state->stance[3]);
    vertex = (v55 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_41(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 30U;
    const float v38 = widowx_rs_max(state->stance[2], state->floor[0]);
    vertex = (v38 >= best) ? 31U : vertex;
    best = (v38 > best) ? v38 : best;
    const float v39 = widowx_rs_max(state->floor[0], 0.0F);
    vertex = (v39 >= best) ? 19U : vertex;
    best = (v39 > best) ? v39 : best;
    const float v40 = state->floor[0] / 0.0F;
    const float v42 = v40 * (-72.49379F);
    vertex = (v42 >= best) ? 31U : vertex;
    best = (v42 > best) ? v42 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v43 = fabsf(state->floor[0]);
    const float v44 = state->stance[0] / v43;
    vertex = (v44 >= best) ? 30U : vertex;
    best = (v44 > best) ? v44 : best;
    vertex = (10.948133F >= best) ? 16U : vertex;
    best = (10.948133F > best) ? 10.948133F : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_14(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 15U;
    const float v13 = state->stance[1] / 11.184899F;
    vertex = (v13 >= best) ? 34U : vertex;
    best = (v13 > best) ? v13 : best;
    vertex = (11.302588F >= best) ? 16U : vertex;
    best = (11.302588F > best) ? 11.302588F : best;
    const float v29 = 0.0F - state->floor[0];
    vertex = (v29 >= best) ? 31U : vertex;
    best = (v29 > best) ? v29 : best;
    const float v75 = (-3.5602038F) - state->stance[0];
    vertex = (v75 >= best) ? 31U : vertex;
    best = (v75 > best) ? v75 : best;
    const float v46 = state->stance[1] * state->floor[0];
    vertex = (v46 >= best) ? 31U : vertex;
    best = (v46 > best) ? v46 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 31U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v11 = 164.8815F * state->stance[3];
    vertex = (v11 >= best) ? 36U : vertex;
    best = (v11 > best) ? v11 : best;
    const float v15 = state->stance[1] / 0.0F;
    vertex = (v15 >= best) ? 15U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_22(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 35U;
    const float v17 = (-3.3748567F) - state->stance[0];
    const float v37 = widowx_rs_min(v17, state->floor[0]);
    vertex = (v37 >= best) ? 31U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 20U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v76 = state->floor[0] * state->floor[0];
    vertex = (v76 >= best) ? 8U : vertex;
    best = (v76 > best) ? v76 : best;
    vertex = (v17 >= best) ? 31U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v40 = state->floor[0] / 0.0F;
    const float v42 = v40 * (-72.49379F);
    vertex = (v42 >= best) ? 33U : vertex;
    best = (v42 > best) ? v42 : best;
    vertex = (22.918602F >= best) ? 37U : vertex;
    best = (22.918602F > best) ? 22.918602F : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 13U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v11 = 164.8815F * state->stance[3];
    vertex = (v11 >= best) ? 36U : vertex;
    best = (v11 > best) ? v11 : best;
    const float v79 = state->stance[0] + state->floor[0];
    const float v80 = v79 / 9.539528F;
    vertex = (v80 >= best) ? 37U : vertex;
    best = (v80 > best) ? v80 : best;
    const float v71 = state->stance[1] - state->floor[0];
    vertex = (v71 >= best) ? 35U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_23(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 34U;
    const float v73 = state->stance[1] / 6.928064F;
    vertex = (v73 >= best) ? 21U : vertex;
    best = (v73 > best) ? v73 : best;
    const float v57 = state->stance[3] / 15.430052F;
    vertex = (v57 >= best) ? 33U : vertex;
    best = (v57 > best) ? v57 : best;
    const float v43 = fabsf(state->floor[0]);
    const float v44 = state->stance[0] / v43;
    vertex = (v44 >= best) ? 30U : vertex;
    best = (v44 > best) ? v44 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 22U : vertex;
    best = (v8 > best) ? v8 : best;
    vertex = (22.918602F >= best) ? 37U : vertex;
    best = (22.918602F > best) ? 22.918602F : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v22 = widowx_rs_max((-161.71835F), state->stance[2]);
    vertex = (v22 >= best) ? 34U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_35(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 35U;
    const float v17 = (-3.3748567F) - state->stance[0];
    const float v37 = widowx_rs_min(v17, state->floor[0]);
    vertex = (v37 >= best) ? 31U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v81 = widowx_rs_negate_if_less((-3.3748567F), state->stance[0]);
    vertex = (v81 >= best) ? 31U : vertex;
    best = (v81 > best) ? v81 : best;
    const float v67 = state->stance[2] + state->stance[2];
    vertex = (v67 >= best) ? 23U : vertex;
    best = (v67 > best) ? v67 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 24U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    best = (v5 > best) ? v5 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 35U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_16(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 25U;
    const float v43 = fabsf(state->floor[0]);
    vertex = (v43 >= best) ? 19U : vertex;
    best = (v43 > best) ? v43 : best;
    const float v40 = state->floor[0] / 0.0F;
    const float v42 = v40 * (-72.49379F);
    vertex = (v42 >= best) ? 33U : vertex;
    best = (v42 > best) ? v42 : best;
    const float v71 = state->stance[1] - state->floor[0];
    vertex = (v71 >= best) ? 35U : vertex;
    best = (v71 > best) ? v71 : best;
    vertex = (22.918602F >= best) ? 10U : vertex;
    best = (22.918602F > best) ? 22.918602F : best;
    const float v46 = state->stance[1] * state->floor[0];
    vertex = (v46 >= best) ? 8U : vertex;
    best = (v46 > best) ? v46 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 20U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v11 = 164.8815F * state->stance[3];
    vertex = (v11 >= best) ? 36U : vertex;
    best = (v11 > best) ? v11 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 25U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_43(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 33U;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v55 = widowx_rs_min(state->stance[2], state->stance[3]);
    vertex = (v55 >= best) ? 31U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v70 = widowx_rs_max(state->stance[0], 0.0F);
    vertex = (v70 >= best) ? 33U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_38(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 2U;
    const float v67 = state->stance[2] + state->stance[2];
    vertex = (v67 >= best) ? 23U : vertex;
    best = (v67 > best) ? v67 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v48 = fabsf(state->stance[3]);
    vertex = (v48 >= best) ? 24U : vertex;
    best = (v48 > best) ? v48 : best;
    const float v69 = widowx_rs_min(state->stance[2], 213.59233F);
    vertex = (v69 >= best) ? 37U : vertex;
    best = (v69 > best) ? v69 : best;
    const float v43 = fabsf(state->floor[0]);
    const float v58 = state->stance[1] / v43;
    vertex = (v58 >= best) ? 30U : vertex;
    best = (v58 > best) ? v58 : best;
    vertex = (4.372006F >= best) ? 31U : vertex;
    best = (4.372006F > best) ? 4.372006F : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 31U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 16U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v36 = state->stance[1] + 9.539528F;
    vertex = (v36 >= best) ? 2U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_33(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 35U;
    const float v43 = fabsf(state->floor[0]);
    const float v82 = state->stance[2] / v43;
    vertex = (v82 >= best) ? 30U : vertex;
    best = (v82 > best) ? v82 : best;
    const float v83 = state->floor[0] - (-22.172918F);
    const float v84 = 9.539528F + v83;
    vertex = (v84 >= best) ? 26U : vertex;
    best = (v84 > best) ? v84 : best;
    const float v85 = widowx_rs_max(state->stance[2], 99.64715F);
    vertex = (v85 >= best) ? 10U : vertex;
    best = (v85 > best) ? v85 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 9U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v87 = (-72.89382F) / state->floor[0];
    vertex = (v87 >= best) ? 35U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_42(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 16U;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v55 = widowx_rs_min(state->stance[2], state->stance[3]);
    vertex = (v55 >= best) ? 31U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 31U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    best = (v5 > best) ? v5 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 37U : vertex;
    best = (zero > best) ? zero : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 16U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_30(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 2U;
    const float v43 = fabsf(state->floor[0]);
    const float v44 = state->stance[0] / v43;
    vertex = (v44 >= best) ? 30U : vertex;
    best = (v44 > best) ? v44 : best;
    const float v79 = state->stance[0] + state->floor[0];
    const float v80 = v79 / 9.539528F;
    vertex = (v80 >= best) ? 37U : vertex;
    best = (v80 > best) ? v80 : best;
    const float v91 = state->stance[1] / state->floor[0];
    vertex = (v91 >= best) ? 21U : vertex;
    best = (v91 > best) ? v91 : best;
    const float v66 = state->stance[2] - 99.64715F;
    vertex = (v66 >= best) ? 17U : vertex;
    best = (v66 > best) ? v66 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 18U : vertex;
    best = (v8 > best) ? v8 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 35U : vertex;
    best = (zero > best) ? zero : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 9U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v40 = state->floor[0] / 0.0F;
    const float v42 = v40 * (-72.49379F);
    vertex = (v42 >= best) ? 27U : vertex;
    best = (v42 > best) ? v42 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_37(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    best = (v5 > best) ? v5 : best;
    vertex = (4.372006F >= best) ? 31U : vertex;
    best = (4.372006F > best) ? 4.372006F : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_24(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 30U;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 17U : vertex;
    best = (v17 > best) ? v17 : best;
    vertex = (22.918602F >= best) ? 37U : vertex;
    best = (22.918602F > best) ? 22.918602F : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 18U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v57 = state->stance[3] / 15.430052F;
    vertex = (v57 >= best) ? 33U : vertex;
    best = (v57 > best) ? v57 : best;
    const float v36 = state->stance[1] + 9.539528F;
    vertex = (v36 >= best) ? 2U : vertex;
    best = (v36 > best) ? v36 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_40(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 33U;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 31U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v90 = fabsf(state->stance[0]);
    vertex = (v90 >= best) ? 31U : vertex;
    best = (v90 > best) ? v90 : best;
    const float v55 = widowx_rs_min(state->stance[2], state->stance[3]);
    vertex = (v55 >= best) ? 31U : vertex;
    best = (v55 > best) ? v55 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 33U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_39(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 30U;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    vertex = (v17 >= best) ? 31U : vertex;
    best = (v17 > best) ? v17 : best;
    const float v60 = state->stance[0] / 17.709658F;
    vertex = (v60 >= best) ? 30U : vertex;
    best = (v60 > best) ? v60 : best;
    const float v55 = widowx_rs_min(state->stance[2], state->stance[3]);
    vertex = (v55 >= best) ? 31U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v61 = 0.0F * state->stance[2];
    vertex = (v61 >= best) ? 32U : vertex;
    best = (v61 > best) ? v61 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 16U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v43 = fabsf(state->floor[0]);
    const float v44 = state->stance[0] / v43;
    vertex = (v44 >= best) ? 30U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_17(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 2U;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 14U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    const float v37 = widowx_rs_min(v17, state->floor[0]);
    vertex = (v37 >= best) ? 31U : vertex;
    best = (v37 > best) ? v37 : best;
    vertex = (22.918602F >= best) ? 37U : vertex;
    best = (22.918602F > best) ? 22.918602F : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 13U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v76 = state->floor[0] * state->floor[0];
    vertex = (v76 >= best) ? 28U : vertex;
    best = (v76 > best) ? v76 : best;
    const float v55 = widowx_rs_min(state->stance[2], state->stance[3]);
    vertex = (v55 >= best) ? 31U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v78 = state->stance[1] / (-9.539528F);
    vertex = (v78 >= best) ? 2U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_34(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 14U;
    const float v89 = state->floor[0] * (-4.136917F);
    vertex = (v89 >= best) ? 30U : vertex;
    best = (v89 > best) ? v89 : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 2U : vertex;
    best = (v5 > best) ? v5 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 31U : vertex;
    best = (zero > best) ? zero : best;
    const float v40 = state->floor[0] / 0.0F;
    const float v42 = v40 * (-72.49379F);
    vertex = (v42 >= best) ? 31U : vertex;
    best = (v42 > best) ? v42 : best;
    const float v43 = fabsf(state->floor[0]);
    vertex = (v43 >= best) ? 29U : vertex;
    best = (v43 > best) ? v43 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v36 = state->stance[1] + 9.539528F;
    vertex = (v36 >= best) ? 2U : vertex;
    best = (v36 > best) ? v36 : best;
    const float v44 = state->stance[0] / v43;
    vertex = (v44 >= best) ? 14U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_31(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 26U;
    vertex = (7.3802834F >= best) ? 35U : vertex;
    best = (7.3802834F > best) ? 7.3802834F : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 17U : vertex;
    best = (v8 > best) ? v8 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v36 = state->stance[1] + 9.539528F;
    vertex = (v36 >= best) ? 26U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_18(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    vertex = (22.918602F >= best) ? 37U : vertex;
    best = (22.918602F > best) ? 22.918602F : best;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 33U : vertex;
    best = (v5 > best) ? v5 : best;
    const float v17 = (-3.3748567F) - state->stance[0];
    const float v37 = widowx_rs_min(v17, state->floor[0]);
    vertex = (v37 >= best) ? 31U : vertex;
    best = (v37 > best) ? v37 : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 13U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v76 = state->floor[0] * state->floor[0];
    vertex = (v76 >= best) ? 8U : vertex;
    best = (v76 > best) ? v76 : best;
    const float v55 = widowx_rs_min(state->stance[2], state->stance[3]);
    vertex = (v55 >= best) ? 31U : vertex;
    best = (v55 > best) ? v55 : best;
    const float v78 = state->stance[1] / (-9.539528F);
    vertex = (v78 >= best) ? 2U : vertex;
    best = (v78 > best) ? v78 : best;
    const float v43 = fabsf(state->floor[0]);
    const float v44 = state->stance[0] / v43;
    vertex = (v44 >= best) ? 18U : vertex;
    best = (v44 > best) ? v44 : best;
    const float v8 = fabsf(state->stance[2]);
    vertex = (v8 >= best) ? 20U : vertex;
    best = (v8 > best) ? v8 : best;
    vertex = (v17 >= best) ? 31U : vertex;
    return vertex;
}

static uint32_t widowx_rs_team_36(const widowx_rs_state_t *state)
{
    float best = -FLT_MAX;
    uint32_t vertex = 31U;
    const float v5 = state->stance[1] / 9.539528F;
    vertex = (v5 >= best) ? 35U : vertex;
    best = (v5 > best) ? v5 : best;
    const volatile float constant = 0.0F;
    const float zero = constant;
    vertex = (zero >= best) ? 33U : vertex;
    best = (zero > best) ? zero : best;
    const float v2 = state->stance[0] / 0.0F;
    vertex = (v2 >= best) ? 30U : vertex;
    best = (v2 > best) ? v2 : best;
    const float v55 = widowx_rs_min(state->stance[2], state->stance[3]);
    vertex = (v55 >= best) ? 31U : vertex;
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
            vertex = widowx_rs_team_7(state);
            break;
        case 2U:
            vertex = widowx_rs_team_44(state);
            break;
        case 3U:
            vertex = widowx_rs_team_5(state);
            break;
        case 4U:
            vertex = widowx_rs_team_11(state);
            break;
        case 5U:
            vertex = widowx_rs_team_10(state);
            break;
        case 6U:
            vertex = widowx_rs_team_13(state);
            break;
        case 7U:
            vertex = widowx_rs_team_12(state);
            break;
        case 8U:
            vertex = widowx_rs_team_32(state);
            break;
        case 9U:
            vertex = widowx_rs_team_45(state);
            break;
        case 10U:
            vertex = widowx_rs_team_41(state);
            break;
        case 11U:
            vertex = widowx_rs_team_14(state);
            break;
        case 12U:
            vertex = widowx_rs_team_22(state);
            break;
        case 13U:
            vertex = widowx_rs_team_23(state);
            break;
        case 14U:
            vertex = widowx_rs_team_35(state);
            break;
        case 15U:
            vertex = widowx_rs_team_16(state);
            break;
        case 16U:
            vertex = widowx_rs_team_43(state);
            break;
        case 17U:
            vertex = widowx_rs_team_38(state);
            break;
        case 18U:
            vertex = widowx_rs_team_33(state);
            break;
        case 19U:
            vertex = widowx_rs_team_42(state);
            break;
        case 20U:
            vertex = widowx_rs_team_30(state);
            break;
        case 21U:
            vertex = widowx_rs_team_37(state);
            break;
        case 22U:
            vertex = widowx_rs_team_24(state);
            break;
        case 23U:
            vertex = widowx_rs_team_40(state);
            break;
        case 24U:
            vertex = widowx_rs_team_39(state);
            break;
        case 25U:
            vertex = widowx_rs_team_17(state);
            break;
        case 26U:
            vertex = widowx_rs_team_34(state);
            break;
        case 27U:
            vertex = widowx_rs_team_31(state);
            break;
        case 28U:
            vertex = widowx_rs_team_18(state);
            break;
        case 29U:
            vertex = widowx_rs_team_36(state);
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
        { { -798.6424F, -2578.1226F, 593.26575F, -1148.5238F }, { 171.9165F } },
        { { 1724.8977F, -239.07426F, -2134.1018F, 1533.6041F }, { 428.2142F } },
        { { -137.12389F, 474.37292F, -2460.9207F, -966.0493F }, { 274.7966F } },
        { { -1799.9268F, 3016.9028F, 2533.5088F, 1829.6047F }, { 80.74581F } },
        { { -1280.2272F, -121.022995F, -630.7772F, -1989.9497F }, { 29.645329F } },
        { { -2578.7893F, 156.82542F, -1424.5941F, -1684.1997F }, { 60.87548F } },
        { { 4021.4275F, 1198.0511F, -2406.94F, 326.01794F }, { 442.83307F } },
        { { 1676.0879F, -1699.3021F, 2784.0715F, -1521.2797F }, { 383.30878F } },
        { { 2488.8496F, 499.7877F, 2455.1895F, -493.87448F }, { 288.96332F } },
        { { 3457.7278F, -991.9888F, 773.029F, -893.16724F }, { 137.45839F } },
        { { 588.55566F, 2681.4429F, -952.8564F, 1666.7648F }, { 603.69525F } },
        { { 3189.0532F, 1427.9913F, 93.55876F, 613.4954F }, { 344.57886F } },
        { { 936.392F, -171.90839F, 911.61755F, 436.12476F }, { 39.478603F } },
        { { -2124.7869F, -488.3765F, -824.03076F, -561.8875F }, { 154.245F } },
        { { 732.9136F, -1380.6349F, 2396.8271F, 630.6199F }, { 131.1711F } },
        { { 988.5016F, -842.48456F, -1515.1866F, 1978.4678F }, { 326.6399F } },
    };
    static const uint16_t actions[16] = {
        1U, 0U, 1U, 6U, 1U, 1U, 0U, 3U, 4U, 0U, 0U, 0U, 4U, 1U, 4U, 0U
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
