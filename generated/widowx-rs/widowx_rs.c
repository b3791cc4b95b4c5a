/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_rs --profile fast
 * Graph SHA-256: 4c66c6b65c6c713d5ad1fe31be297b7d3fcebbf6d3d7971a9a27b9132c25b11f
 * 30 teams (16 on the longest walk), 210 edges, 156 programs, 56 distinct operations.
 * Computes in f32 with own maths.
 */
#include "widowx_rs.h"

#include <float.h>
#include <math.h>

#ifdef __FAST_MATH__
#error "fast-math reorders operations and drops NaN: the policy would act differently"
#endif
/* 16 widens what is narrower than float, and no float. */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16)
#error "float expressions must be computed in float: the policy would act differently"
#endif
/* A product and a sum are rounded each: nothing may fuse them. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off") /* GCC ignores the standard's pragma, and fuses in GNU modes and in C++. */
#elif defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)
#else
#pragma STDC FP_CONTRACT OFF
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

/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */

uint16_t widowx_rs_infer(const widowx_rs_state_t *state)
{
    uint32_t vertex;

    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 1U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 2U;
        }
        const float v6 = state->stance[1] - 9.539528F;

        if (v6 >= best) {
            best = v6;
            way = 3U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 4U;
        }
        const float v11 = 164.8815F * state->stance[3];

        if (v11 >= best) {
            best = v11;
            way = 5U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 5U;
            goto decided;
        } else if (way == 2U) {
            goto team_7;
        } else if (way == 3U) {
            goto team_44;
        } else if (way == 4U) {
            goto team_5;
        } else if (way == 5U) {
            vertex = 6U;
            goto decided;
        } else {
            vertex = 2U;
            goto decided;
        }
    }

team_5:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v27 = state->stance[3] * (-6.3484564F);

        if (v27 >= best) {
            best = v27;
            way = 3U;
        }
        const float v33 = widowx_rs_max(state->stance[2], (-3.385455F));

        if (v33 >= best) {
            best = v33;
            way = 5U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 1U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];
        const float v29 = v17 * state->floor[0];

        if (v29 >= best) {
            best = v29;
            way = 2U;
        }
        const float v34 = (-6.3484564F) - state->stance[3];

        if (v34 >= best) {
            best = v34;
            way = 3U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 4U;
        }
        const float v23 = (-3.3748567F) - state->floor[0];

        if (v23 >= best) {
            best = v23;
            way = 5U;
        }
        const float v11 = 164.8815F * state->stance[3];

        if (v11 >= best) {
            best = v11;
            way = 5U;
        }
        const float v13 = state->stance[1] / 11.184899F;

        if (v13 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            goto team_7;
        } else if (way == 2U) {
            vertex = 1U;
            goto decided;
        } else if (way == 3U) {
            goto team_10;
        } else if (way == 4U) {
            goto team_44;
        } else {
            vertex = 6U;
            goto decided;
        }
    }

team_7:
    {
        float best = -FLT_MAX;
        uint32_t way = 8U;
        const float v23 = (-3.3748567F) - state->floor[0];

        if (v23 >= best) {
            best = v23;
            way = 1U;
        }
        const float v6 = state->stance[1] - 9.539528F;

        if (v6 >= best) {
            best = v6;
            way = 2U;
        }
        const float v25 = (-10.533181F) - state->floor[0];

        if (v25 >= best) {
            best = v25;
            way = 3U;
        }
        const float v28 = 0.0F - state->floor[0];

        if (v28 >= best) {
            best = v28;
            way = 6U;
        }
        const float v21 = widowx_rs_max((-161.71835F), state->stance[2]);

        if (v21 >= best) {
            best = v21;
            way = 4U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 5U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];
        const float v29 = v17 * state->floor[0];

        if (v29 >= best) {
            best = v29;
            way = 6U;
        }
        const float v27 = state->stance[3] * (-6.3484564F);

        if (v27 >= best) {
            best = v27;
            way = 7U;
        }
        const float v30 = state->stance[3] / state->floor[0];

        if (v30 >= best) {
            way = 8U;
        }

        if (way == 1U) {
            vertex = 6U;
            goto decided;
        } else if (way == 2U) {
            goto team_44;
        } else if (way == 3U) {
            goto team_11;
        } else if (way == 4U) {
            vertex = 4U;
            goto decided;
        } else if (way == 5U) {
            vertex = 5U;
            goto decided;
        } else if (way == 6U) {
            vertex = 1U;
            goto decided;
        } else if (way == 7U) {
            goto team_10;
        } else {
            goto team_13;
        }
    }

team_10:
    {
        float best = -FLT_MAX;
        uint32_t way = 7U;
        const float v13 = state->stance[1] / 11.184899F;

        if (v13 >= best) {
            best = v13;
            way = 1U;
        }
        const float v61 = state->stance[1] - 9.689877F;

        if (v61 >= best) {
            best = v61;
            way = 2U;
        }

        if (24.873356F >= best) {
            best = 24.873356F;
            way = 3U;
        }
        const float v42 = fabsf(state->floor[0]);
        const float v43 = state->stance[0] / v42;

        if (v43 >= best) {
            best = v43;
            way = 4U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 5U;
        }
        const float v28 = 0.0F - state->floor[0];

        if (v28 >= best) {
            best = v28;
            way = 6U;
        }
        const float v15 = state->stance[1] / 0.0F;

        if (v15 >= best) {
            way = 7U;
        }

        if (way == 1U) {
            vertex = 4U;
            goto decided;
        } else if (way == 2U) {
            goto team_32;
        } else if (way == 3U) {
            goto team_12;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else if (way == 5U) {
            goto team_45;
        } else if (way == 6U) {
            vertex = 1U;
            goto decided;
        } else {
            goto team_13;
        }
    }

team_11:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v13 = state->stance[1] / 11.184899F;

        if (v13 >= best) {
            best = v13;
            way = 1U;
        }
        const float v15 = state->stance[1] / 0.0F;

        if (v15 >= best) {
            best = v15;
            way = 2U;
        }
        const float v11 = 164.8815F * state->stance[3];

        if (v11 >= best) {
            best = v11;
            way = 3U;
        }

        if (24.873356F >= best) {
            best = 24.873356F;
            way = 4U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 5U;
        }

        if (state->stance[3] >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 4U;
            goto decided;
        } else if (way == 2U) {
            goto team_13;
        } else if (way == 3U) {
            vertex = 6U;
            goto decided;
        } else if (way == 4U) {
            goto team_12;
        } else if (way == 5U) {
            vertex = 1U;
            goto decided;
        } else {
            vertex = 7U;
            goto decided;
        }
    }

team_12:
    {
        float best = -FLT_MAX;
        uint32_t way = 8U;
        const float v11 = 164.8815F * state->stance[3];

        if (v11 >= best) {
            best = v11;
            way = 1U;
        }
        const float v15 = state->stance[1] / 0.0F;

        if (v15 >= best) {
            best = v15;
            way = 2U;
        }
        const float v42 = fabsf(state->floor[0]);
        const float v56 = state->stance[1] / v42;

        if (v56 >= best) {
            best = v56;
            way = 3U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 4U;
        }
        const float v51 = widowx_rs_negate_if_less(state->stance[1], (-26.200392F));

        if (v51 >= best) {
            best = v51;
            way = 5U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 6U;
        }

        if (11.302588F >= best) {
            best = 11.302588F;
            way = 7U;
        }
        const float v28 = 0.0F - state->floor[0];

        if (v28 >= best) {
            way = 8U;
        }

        if (way == 1U) {
            vertex = 6U;
            goto decided;
        } else if (way == 2U) {
            goto team_16;
        } else if (way == 3U) {
            vertex = 0U;
            goto decided;
        } else if (way == 4U) {
            goto team_45;
        } else if (way == 5U) {
            vertex = 3U;
            goto decided;
        } else if (way == 6U) {
            goto team_44;
        } else if (way == 7U) {
            goto team_43;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_13:
    {
        float best = 22.918602F;
        uint32_t way = 1U;
        const float v47 = fabsf(state->stance[3]);

        if (v47 >= best) {
            best = v47;
            way = 2U;
        }
        const float v11 = 164.8815F * state->stance[3];

        if (v11 >= best) {
            best = v11;
            way = 3U;
        }
        const float v35 = state->stance[1] + 9.539528F;

        if (v35 >= best) {
            best = v35;
            way = 4U;
        }
        const float v49 = state->stance[0] / 11.077008F;

        if (v49 >= best) {
            best = v49;
            way = 5U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 6U;
        }
        const float v42 = fabsf(state->floor[0]);
        const float v43 = state->stance[0] / v42;

        if (v43 >= best) {
            best = v43;
            way = 7U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 8U;
        }
        const float v36 = widowx_rs_min(v17, state->floor[0]);

        if (v36 >= best) {
            way = 9U;
        }

        if (way == 1U) {
            goto team_41;
        } else if (way == 2U) {
            goto team_32;
        } else if (way == 3U) {
            vertex = 6U;
            goto decided;
        } else if (way == 4U) {
            goto team_14;
        } else if (way == 5U) {
            goto team_22;
        } else if (way == 6U) {
            goto team_23;
        } else if (way == 7U) {
            goto team_35;
        } else if (way == 8U) {
            goto team_45;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_22:
    {
        float best = -FLT_MAX;
        uint32_t way = 8U;
        const float v17 = (-3.3748567F) - state->stance[0];
        const float v36 = widowx_rs_min(v17, state->floor[0]);

        if (v36 >= best) {
            best = v36;
            way = 3U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 1U;
        }
        const float v74 = state->floor[0] * state->floor[0];

        if (v74 >= best) {
            best = v74;
            way = 2U;
        }

        if (v17 >= best) {
            best = v17;
            way = 3U;
        }
        const float v39 = state->floor[0] / 0.0F;
        const float v41 = v39 * (-72.49379F);

        if (v41 >= best) {
            best = v41;
            way = 4U;
        }

        if (22.918602F >= best) {
            best = 22.918602F;
            way = 7U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 5U;
        }
        const float v11 = 164.8815F * state->stance[3];

        if (v11 >= best) {
            best = v11;
            way = 6U;
        }
        const float v77 = state->stance[0] + state->floor[0];
        const float v78 = v77 / 9.539528F;

        if (v78 >= best) {
            best = v78;
            way = 7U;
        }
        const float v69 = state->stance[1] - state->floor[0];

        if (v69 >= best) {
            way = 8U;
        }

        if (way == 1U) {
            goto team_30;
        } else if (way == 2U) {
            goto team_32;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else if (way == 4U) {
            vertex = 3U;
            goto decided;
        } else if (way == 5U) {
            goto team_23;
        } else if (way == 6U) {
            vertex = 6U;
            goto decided;
        } else if (way == 7U) {
            vertex = 7U;
            goto decided;
        } else {
            vertex = 5U;
            goto decided;
        }
    }

team_14:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v13 = state->stance[1] / 11.184899F;

        if (v13 >= best) {
            best = v13;
            way = 1U;
        }

        if (11.302588F >= best) {
            best = 11.302588F;
            way = 2U;
        }
        const float v28 = 0.0F - state->floor[0];

        if (v28 >= best) {
            best = v28;
            way = 3U;
        }
        const float v73 = (-3.5602038F) - state->stance[0];

        if (v73 >= best) {
            best = v73;
            way = 3U;
        }
        const float v45 = state->stance[1] * state->floor[0];

        if (v45 >= best) {
            best = v45;
            way = 3U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 3U;
        }
        const float v11 = 164.8815F * state->stance[3];

        if (v11 >= best) {
            best = v11;
            way = 4U;
        }
        const float v15 = state->stance[1] / 0.0F;

        if (v15 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            vertex = 4U;
            goto decided;
        } else if (way == 2U) {
            goto team_43;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else if (way == 4U) {
            vertex = 6U;
            goto decided;
        } else {
            goto team_16;
        }
    }

team_16:
    {
        float best = -FLT_MAX;
        uint32_t way = 8U;
        const float v42 = fabsf(state->floor[0]);

        if (v42 >= best) {
            best = v42;
            way = 1U;
        }
        const float v39 = state->floor[0] / 0.0F;
        const float v41 = v39 * (-72.49379F);

        if (v41 >= best) {
            best = v41;
            way = 2U;
        }
        const float v69 = state->stance[1] - state->floor[0];

        if (v69 >= best) {
            best = v69;
            way = 3U;
        }

        if (22.918602F >= best) {
            best = 22.918602F;
            way = 4U;
        }
        const float v45 = state->stance[1] * state->floor[0];

        if (v45 >= best) {
            best = v45;
            way = 5U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 6U;
        }
        const float v11 = 164.8815F * state->stance[3];

        if (v11 >= best) {
            best = v11;
            way = 7U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            way = 8U;
        }

        if (way == 1U) {
            goto team_42;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else if (way == 3U) {
            vertex = 5U;
            goto decided;
        } else if (way == 4U) {
            goto team_41;
        } else if (way == 5U) {
            goto team_32;
        } else if (way == 6U) {
            goto team_30;
        } else if (way == 7U) {
            vertex = 6U;
            goto decided;
        } else {
            goto team_17;
        }
    }

team_17:
    {
        float best = -FLT_MAX;
        uint32_t way = 7U;
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 1U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 2U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];
        const float v36 = widowx_rs_min(v17, state->floor[0]);

        if (v36 >= best) {
            best = v36;
            way = 6U;
        }

        if (22.918602F >= best) {
            best = 22.918602F;
            way = 3U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 4U;
        }
        const float v74 = state->floor[0] * state->floor[0];

        if (v74 >= best) {
            best = v74;
            way = 5U;
        }
        const float v53 = widowx_rs_min(state->stance[2], state->stance[3]);

        if (v53 >= best) {
            best = v53;
            way = 6U;
        }
        const float v76 = state->stance[1] / (-9.539528F);

        if (v76 >= best) {
            way = 7U;
        }

        if (way == 1U) {
            goto team_35;
        } else if (way == 2U) {
            vertex = 5U;
            goto decided;
        } else if (way == 3U) {
            vertex = 7U;
            goto decided;
        } else if (way == 4U) {
            goto team_23;
        } else if (way == 5U) {
            goto team_18;
        } else if (way == 6U) {
            vertex = 1U;
            goto decided;
        } else {
            goto team_44;
        }
    }

team_18:
    {
        float best = 22.918602F;
        uint32_t way = 1U;
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 2U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];
        const float v36 = widowx_rs_min(v17, state->floor[0]);

        if (v36 >= best) {
            best = v36;
            way = 8U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 3U;
        }
        const float v74 = state->floor[0] * state->floor[0];

        if (v74 >= best) {
            best = v74;
            way = 4U;
        }
        const float v53 = widowx_rs_min(state->stance[2], state->stance[3]);

        if (v53 >= best) {
            best = v53;
            way = 8U;
        }
        const float v76 = state->stance[1] / (-9.539528F);

        if (v76 >= best) {
            best = v76;
            way = 5U;
        }
        const float v42 = fabsf(state->floor[0]);
        const float v43 = state->stance[0] / v42;

        if (v43 >= best) {
            best = v43;
            way = 6U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 7U;
        }

        if (v17 >= best) {
            way = 8U;
        }

        if (way == 1U) {
            vertex = 7U;
            goto decided;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else if (way == 3U) {
            goto team_23;
        } else if (way == 4U) {
            goto team_32;
        } else if (way == 5U) {
            goto team_44;
        } else if (way == 6U) {
            goto team_33;
        } else if (way == 7U) {
            goto team_30;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_30:
    {
        float best = -FLT_MAX;
        uint32_t way = 9U;
        const float v42 = fabsf(state->floor[0]);
        const float v43 = state->stance[0] / v42;

        if (v43 >= best) {
            best = v43;
            way = 4U;
        }
        const float v77 = state->stance[0] + state->floor[0];
        const float v78 = v77 / 9.539528F;

        if (v78 >= best) {
            best = v78;
            way = 1U;
        }
        const float v89 = state->stance[1] / state->floor[0];

        if (v89 >= best) {
            best = v89;
            way = 2U;
        }
        const float v64 = state->stance[2] - 99.64715F;

        if (v64 >= best) {
            best = v64;
            way = 3U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 4U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 5U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 6U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 7U;
        }
        const float v39 = state->floor[0] / 0.0F;
        const float v41 = v39 * (-72.49379F);

        if (v41 >= best) {
            best = v41;
            way = 8U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            way = 9U;
        }

        if (way == 1U) {
            vertex = 7U;
            goto decided;
        } else if (way == 2U) {
            goto team_37;
        } else if (way == 3U) {
            goto team_38;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else if (way == 5U) {
            goto team_33;
        } else if (way == 6U) {
            vertex = 5U;
            goto decided;
        } else if (way == 7U) {
            goto team_45;
        } else if (way == 8U) {
            goto team_31;
        } else {
            goto team_44;
        }
    }

team_31:
    {
        float best = 7.3802834F;
        uint32_t way = 1U;
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 2U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 3U;
        }
        const float v35 = state->stance[1] + 9.539528F;

        if (v35 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 5U;
            goto decided;
        } else if (way == 2U) {
            goto team_38;
        } else if (way == 3U) {
            vertex = 0U;
            goto decided;
        } else {
            goto team_34;
        }
    }

team_32:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 1U;
        }

        if (22.918602F >= best) {
            best = 22.918602F;
            way = 2U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 3U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 4U;
        }
        const float v35 = state->stance[1] + 9.539528F;

        if (v35 >= best) {
            best = v35;
            way = 6U;
        }
        const float v55 = state->stance[3] / 15.430052F;

        if (v55 >= best) {
            best = v55;
            way = 5U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            goto team_38;
        } else if (way == 2U) {
            vertex = 7U;
            goto decided;
        } else if (way == 3U) {
            vertex = 0U;
            goto decided;
        } else if (way == 4U) {
            goto team_33;
        } else if (way == 5U) {
            vertex = 6U;
            goto decided;
        } else {
            goto team_44;
        }
    }

team_23:
    {
        float best = -FLT_MAX;
        uint32_t way = 7U;
        const float v71 = state->stance[1] / 6.928064F;

        if (v71 >= best) {
            best = v71;
            way = 1U;
        }
        const float v55 = state->stance[3] / 15.430052F;

        if (v55 >= best) {
            best = v55;
            way = 2U;
        }
        const float v42 = fabsf(state->floor[0]);
        const float v43 = state->stance[0] / v42;

        if (v43 >= best) {
            best = v43;
            way = 3U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 4U;
        }

        if (22.918602F >= best) {
            best = 22.918602F;
            way = 5U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 6U;
        }
        const float v21 = widowx_rs_max((-161.71835F), state->stance[2]);

        if (v21 >= best) {
            way = 7U;
        }

        if (way == 1U) {
            goto team_37;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else if (way == 3U) {
            vertex = 0U;
            goto decided;
        } else if (way == 4U) {
            goto team_24;
        } else if (way == 5U) {
            vertex = 7U;
            goto decided;
        } else if (way == 6U) {
            goto team_44;
        } else {
            vertex = 4U;
            goto decided;
        }
    }

team_24:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 1U;
        }

        if (22.918602F >= best) {
            best = 22.918602F;
            way = 2U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 3U;
        }
        const float v55 = state->stance[3] / 15.430052F;

        if (v55 >= best) {
            best = v55;
            way = 4U;
        }
        const float v35 = state->stance[1] + 9.539528F;

        if (v35 >= best) {
            best = v35;
            way = 5U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            goto team_38;
        } else if (way == 2U) {
            vertex = 7U;
            goto decided;
        } else if (way == 3U) {
            goto team_33;
        } else if (way == 4U) {
            vertex = 3U;
            goto decided;
        } else if (way == 5U) {
            goto team_44;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_33:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v42 = fabsf(state->floor[0]);
        const float v80 = state->stance[2] / v42;

        if (v80 >= best) {
            best = v80;
            way = 1U;
        }
        const float v81 = state->floor[0] - (-22.172918F);
        const float v82 = 9.539528F + v81;

        if (v82 >= best) {
            best = v82;
            way = 2U;
        }
        const float v83 = widowx_rs_max(state->stance[2], 99.64715F);

        if (v83 >= best) {
            best = v83;
            way = 3U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 4U;
        }
        const float v85 = (-72.89382F) / state->floor[0];

        if (v85 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            goto team_34;
        } else if (way == 3U) {
            goto team_41;
        } else if (way == 4U) {
            goto team_45;
        } else {
            vertex = 5U;
            goto decided;
        }
    }

team_45:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v51 = widowx_rs_negate_if_less(state->stance[1], (-26.200392F));

        if (v51 >= best) {
            best = v51;
            way = 1U;
        }
        const float v52 = widowx_rs_max(state->stance[1], state->floor[0]);

        if (v52 >= best) {
            best = v52;
            way = 4U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 2U;
        }
        const float v28 = 0.0F - state->floor[0];

        if (v28 >= best) {
            best = v28;
            way = 4U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 3U;
        }

        if (4.372006F >= best) {
            best = 4.372006F;
            way = 4U;
        }
        const float v53 = widowx_rs_min(state->stance[2], state->stance[3]);

        if (v53 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 3U;
            goto decided;
        } else if (way == 2U) {
            vertex = 0U;
            goto decided;
        } else if (way == 3U) {
            vertex = 5U;
            goto decided;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_41:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v37 = widowx_rs_max(state->stance[2], state->floor[0]);

        if (v37 >= best) {
            best = v37;
            way = 2U;
        }
        const float v38 = widowx_rs_max(state->floor[0], 0.0F);

        if (v38 >= best) {
            best = v38;
            way = 1U;
        }
        const float v39 = state->floor[0] / 0.0F;
        const float v41 = v39 * (-72.49379F);

        if (v41 >= best) {
            best = v41;
            way = 2U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 3U;
        }
        const float v42 = fabsf(state->floor[0]);
        const float v43 = state->stance[0] / v42;

        if (v43 >= best) {
            best = v43;
            way = 5U;
        }

        if (10.948133F >= best) {
            best = 10.948133F;
            way = 4U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            goto team_42;
        } else if (way == 2U) {
            vertex = 1U;
            goto decided;
        } else if (way == 3U) {
            goto team_44;
        } else if (way == 4U) {
            goto team_43;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_42:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 1U;
        }
        const float v53 = widowx_rs_min(state->stance[2], state->stance[3]);

        if (v53 >= best) {
            best = v53;
            way = 2U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 2U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 3U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 4U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            vertex = 1U;
            goto decided;
        } else if (way == 3U) {
            goto team_44;
        } else if (way == 4U) {
            vertex = 7U;
            goto decided;
        } else {
            goto team_43;
        }
    }

team_34:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v87 = state->floor[0] * (-4.136917F);

        if (v87 >= best) {
            best = v87;
            way = 3U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 4U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 1U;
        }
        const float v39 = state->floor[0] / 0.0F;
        const float v41 = v39 * (-72.49379F);

        if (v41 >= best) {
            best = v41;
            way = 1U;
        }
        const float v42 = fabsf(state->floor[0]);

        if (v42 >= best) {
            best = v42;
            way = 2U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 3U;
        }
        const float v35 = state->stance[1] + 9.539528F;

        if (v35 >= best) {
            best = v35;
            way = 4U;
        }
        const float v43 = state->stance[0] / v42;

        if (v43 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            vertex = 1U;
            goto decided;
        } else if (way == 2U) {
            goto team_36;
        } else if (way == 3U) {
            vertex = 0U;
            goto decided;
        } else if (way == 4U) {
            goto team_44;
        } else {
            goto team_35;
        }
    }

team_35:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v17 = (-3.3748567F) - state->stance[0];
        const float v36 = widowx_rs_min(v17, state->floor[0]);

        if (v36 >= best) {
            best = v36;
            way = 1U;
        }
        const float v79 = widowx_rs_negate_if_less((-3.3748567F), state->stance[0]);

        if (v79 >= best) {
            best = v79;
            way = 1U;
        }
        const float v65 = state->stance[2] + state->stance[2];

        if (v65 >= best) {
            best = v65;
            way = 2U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 3U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 4U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 5U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 1U;
            goto decided;
        } else if (way == 2U) {
            goto team_40;
        } else if (way == 3U) {
            goto team_39;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else if (way == 5U) {
            goto team_44;
        } else {
            vertex = 5U;
            goto decided;
        }
    }

team_36:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 1U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 2U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 3U;
        }
        const float v53 = widowx_rs_min(state->stance[2], state->stance[3]);

        if (v53 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 5U;
            goto decided;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else if (way == 3U) {
            vertex = 0U;
            goto decided;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_38:
    {
        float best = -FLT_MAX;
        uint32_t way = 7U;
        const float v65 = state->stance[2] + state->stance[2];

        if (v65 >= best) {
            best = v65;
            way = 1U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 7U;
        }
        const float v47 = fabsf(state->stance[3]);

        if (v47 >= best) {
            best = v47;
            way = 2U;
        }
        const float v67 = widowx_rs_min(state->stance[2], 213.59233F);

        if (v67 >= best) {
            best = v67;
            way = 3U;
        }
        const float v42 = fabsf(state->floor[0]);
        const float v56 = state->stance[1] / v42;

        if (v56 >= best) {
            best = v56;
            way = 4U;
        }

        if (4.372006F >= best) {
            best = 4.372006F;
            way = 5U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 5U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 6U;
        }
        const float v35 = state->stance[1] + 9.539528F;

        if (v35 >= best) {
            way = 7U;
        }

        if (way == 1U) {
            goto team_40;
        } else if (way == 2U) {
            goto team_39;
        } else if (way == 3U) {
            vertex = 7U;
            goto decided;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else if (way == 5U) {
            vertex = 1U;
            goto decided;
        } else if (way == 6U) {
            goto team_43;
        } else {
            goto team_44;
        }
    }

team_39:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 1U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 2U;
        }
        const float v58 = state->stance[0] / 17.709658F;

        if (v58 >= best) {
            best = v58;
            way = 5U;
        }
        const float v53 = widowx_rs_min(state->stance[2], state->stance[3]);

        if (v53 >= best) {
            best = v53;
            way = 2U;
        }
        const float v59 = 0.0F * state->stance[2];

        if (v59 >= best) {
            best = v59;
            way = 3U;
        }
        const float v8 = fabsf(state->stance[2]);

        if (v8 >= best) {
            best = v8;
            way = 4U;
        }
        const float v42 = fabsf(state->floor[0]);
        const float v43 = state->stance[0] / v42;

        if (v43 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            vertex = 5U;
            goto decided;
        } else if (way == 2U) {
            vertex = 1U;
            goto decided;
        } else if (way == 3U) {
            vertex = 2U;
            goto decided;
        } else if (way == 4U) {
            goto team_43;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_43:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 1U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 2U;
        }
        const float v53 = widowx_rs_min(state->stance[2], state->stance[3]);

        if (v53 >= best) {
            best = v53;
            way = 3U;
        }
        const float v68 = widowx_rs_max(state->stance[0], 0.0F);

        if (v68 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 5U;
            goto decided;
        } else if (way == 2U) {
            vertex = 0U;
            goto decided;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else {
            vertex = 3U;
            goto decided;
        }
    }

team_40:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 1U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 2U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 3U;
        }
        const float v88 = fabsf(state->stance[0]);

        if (v88 >= best) {
            best = v88;
            way = 3U;
        }
        const float v53 = widowx_rs_min(state->stance[2], state->stance[3]);

        if (v53 >= best) {
            best = v53;
            way = 3U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 5U;
            goto decided;
        } else if (way == 2U) {
            vertex = 0U;
            goto decided;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else {
            vertex = 3U;
            goto decided;
        }
    }

team_37:
    {
        float best = -FLT_MAX;
        uint32_t way = 3U;
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 1U;
        }
        const float v5 = state->stance[1] / 9.539528F;

        if (v5 >= best) {
            best = v5;
            way = 2U;
        }

        if (4.372006F >= best) {
            best = 4.372006F;
            way = 3U;
        }
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            way = 3U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            goto team_44;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_44:
    {
        float best = -FLT_MAX;
        uint32_t way = 3U;
        const float v17 = (-3.3748567F) - state->stance[0];

        if (v17 >= best) {
            best = v17;
            way = 1U;
        }
        const float v2 = state->stance[0] / 0.0F;

        if (v2 >= best) {
            best = v2;
            way = 2U;
        }

        if (state->floor[0] >= best) {
            best = state->floor[0];
            way = 3U;
        }

        if (9.506875F >= best) {
            way = 3U;
        }

        if (way == 1U) {
            vertex = 1U;
            goto decided;
        } else if (way == 2U) {
            vertex = 0U;
            goto decided;
        } else {
            vertex = 2U;
            goto decided;
        }
    }

decided:
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
