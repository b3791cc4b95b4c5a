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

/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */

uint16_t widowx_fs_infer(const widowx_fs_state_t *state)
{
    uint32_t vertex;

    {
        float best = 107.35707F;
        uint32_t way = 1U;
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 3U;
        }
        const float v8 = 0.0F - state->polar[1];

        if (v8 >= best) {
            best = v8;
            way = 2U;
        }
        const float v12 = v4 / 0.0F;
        const float v13 = v12 / 0.0F;

        if (v13 >= best) {
            best = v13;
            way = 3U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            goto team_1;
        } else if (way == 2U) {
            goto team_9;
        } else if (way == 3U) {
            vertex = 4U;
            goto decided;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_1:
    {
        float best = 1.6245565F;
        uint32_t way = 1U;
        const float v15 = 0.0F * state->polar[2];

        if (v15 >= best) {
            best = v15;
            way = 4U;
        }
        const float v16 = widowx_fs_negate_if_less(state->polar[0], 0.0F);

        if (v16 >= best) {
            best = v16;
            way = 4U;
        }
        const float v8 = 0.0F - state->polar[1];

        if (v8 >= best) {
            best = v8;
            way = 2U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 3U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 4U;
        }
        const float v20 = state->polar[1] * (-176.74728F);
        const float v22 = v20 + (-0.52844894F);

        if (v22 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            goto team_7;
        } else if (way == 2U) {
            goto team_9;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else {
            goto team_10;
        }
    }

team_9:
    {
        float best = -FLT_MAX;
        uint32_t way = 3U;
        const float v20 = state->polar[1] * (-176.74728F);
        const float v22 = v20 + (-0.52844894F);

        if (v22 >= best) {
            best = v22;
            way = 1U;
        }
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 3U;
        }

        if (20.1483F >= best) {
            best = 20.1483F;
            way = 2U;
        }
        const float v23 = state->polar[2] + v4;

        if (v23 >= best) {
            way = 3U;
        }

        if (way == 1U) {
            goto team_12;
        } else if (way == 2U) {
            goto team_11;
        } else {
            vertex = 4U;
            goto decided;
        }
    }

team_7:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v32 = 0.7582224F * state->polar[0];

        if (v32 >= best) {
            best = v32;
            way = 5U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 1U;
        }
        const float v34 = 42.029076F / state->polar[1];

        if (v34 >= best) {
            best = v34;
            way = 2U;
        }
        const float v20 = state->polar[1] * (-176.74728F);
        const float v22 = v20 + (-0.52844894F);

        if (v22 >= best) {
            best = v22;
            way = 3U;
        }

        if (3.135279F >= best) {
            best = 3.135279F;
            way = 4U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 5U;
        }
        const float v4 = state->polar[2] - 0.7582224F;
        const float v12 = v4 / 0.0F;

        if (v12 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 1U;
            goto decided;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else if (way == 3U) {
            goto team_10;
        } else if (way == 4U) {
            goto team_13;
        } else if (way == 5U) {
            vertex = 0U;
            goto decided;
        } else {
            vertex = 4U;
            goto decided;
        }
    }

team_10:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v20 = state->polar[1] * (-176.74728F);
        const float v22 = v20 + (-0.52844894F);

        if (v22 >= best) {
            best = v22;
            way = 1U;
        }
        const float v46 = (-107.57004F) / state->polar[2];

        if (v46 >= best) {
            best = v46;
            way = 2U;
        }
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 3U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 4U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 6U;
        }
        const float v47 = 0.0F / state->polar[1];

        if (v47 >= best) {
            best = v47;
            way = 6U;
        }

        if (20.1483F >= best) {
            best = 20.1483F;
            way = 5U;
        }
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            goto team_12;
        } else if (way == 2U) {
            goto team_23;
        } else if (way == 3U) {
            vertex = 4U;
            goto decided;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else if (way == 5U) {
            goto team_11;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_11:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 1U;
        }
        const float v52 = state->polar[2] - 0.75724316F;

        if (v52 >= best) {
            best = v52;
            way = 1U;
        }
        const float v43 = state->polar[2] + (-117.26495F);

        if (v43 >= best) {
            best = v43;
            way = 1U;
        }

        if (1.6245565F >= best) {
            best = 1.6245565F;
            way = 2U;
        }
        const float v54 = state->polar[0] - 0.7258825F;

        if (v54 >= best) {
            best = v54;
            way = 5U;
        }
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 3U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 4U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            vertex = 4U;
            goto decided;
        } else if (way == 2U) {
            goto team_15;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else if (way == 4U) {
            goto team_30;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_12:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v49 = (-117.26495F) - state->polar[2];

        if (v49 >= best) {
            best = v49;
            way = 1U;
        }
        const float v50 = state->polar[0] + (-117.26495F);

        if (v50 >= best) {
            best = v50;
            way = 4U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 2U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 3U;
        }
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 4U;
        }

        if (26.139645F >= best) {
            way = 5U;
        }

        if (way == 1U) {
            goto team_20;
        } else if (way == 2U) {
            vertex = 0U;
            goto decided;
        } else if (way == 3U) {
            goto team_36;
        } else if (way == 4U) {
            vertex = 4U;
            goto decided;
        } else {
            goto team_13;
        }
    }

team_13:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 1U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 2U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 6U;
        }

        if (1.6245565F >= best) {
            best = 1.6245565F;
            way = 3U;
        }
        const float v27 = state->polar[1] / state->polar[1];

        if (v27 >= best) {
            best = v27;
            way = 4U;
        }
        const float v28 = widowx_fs_max(0.0F, state->polar[0]);
        const float v29 = state->polar[1] - v28;

        if (v29 >= best) {
            best = v29;
            way = 5U;
        }
        const float v31 = state->polar[0] - 1.0168722F;

        if (v31 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 4U;
            goto decided;
        } else if (way == 2U) {
            goto team_30;
        } else if (way == 3U) {
            goto team_14;
        } else if (way == 4U) {
            goto team_39;
        } else if (way == 5U) {
            vertex = 3U;
            goto decided;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_14:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 1U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 2U;
        }
        const float v55 = state->polar[1] / 0.0F;

        if (v55 >= best) {
            best = v55;
            way = 3U;
        }

        if (1.6245565F >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 4U;
            goto decided;
        } else if (way == 2U) {
            goto team_30;
        } else if (way == 3U) {
            goto team_24;
        } else {
            goto team_15;
        }
    }

team_15:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 1U;
        }
        const float v4 = state->polar[2] - 0.7582224F;
        const float v61 = widowx_fs_max(state->polar[2], v4);

        if (v61 >= best) {
            best = v61;
            way = 2U;
        }

        if (v4 >= best) {
            best = v4;
            way = 3U;
        }

        if (INFINITY >= best) {
            way = 4U;
        }

        if (way == 1U) {
            goto team_23;
        } else if (way == 2U) {
            vertex = 4U;
            goto decided;
        } else if (way == 3U) {
            vertex = 2U;
            goto decided;
        } else {
            goto team_17;
        }
    }

team_17:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v57 = state->polar[2] - (-6.7057414F);

        if (v57 >= best) {
            best = v57;
            way = 4U;
        }

        if (6.543999F >= best) {
            best = 6.543999F;
            way = 1U;
        }
        const float v55 = state->polar[1] / 0.0F;

        if (v55 >= best) {
            best = v55;
            way = 2U;
        }
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 5U;
        }
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 3U;
        }
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 4U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 5U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 7U;
            goto decided;
        } else if (way == 2U) {
            goto team_24;
        } else if (way == 3U) {
            goto team_42;
        } else if (way == 4U) {
            vertex = 2U;
            goto decided;
        } else if (way == 5U) {
            vertex = 1U;
            goto decided;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_23:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 1U;
        }
        const float v69 = widowx_fs_negate_if_less(state->polar[1], 229.17769F);

        if (v69 >= best) {
            best = v69;
            way = 2U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 3U;
        }
        const float v70 = state->polar[1] * (-107.57004F);

        if (v70 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 4U;
            goto decided;
        } else if (way == 2U) {
            goto team_38;
        } else if (way == 3U) {
            goto team_24;
        } else {
            goto team_37;
        }
    }

team_24:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 1U;
        }
        const float v69 = widowx_fs_negate_if_less(state->polar[1], 229.17769F);

        if (v69 >= best) {
            best = v69;
            way = 5U;
        }
        const float v43 = state->polar[2] + (-117.26495F);

        if (v43 >= best) {
            best = v43;
            way = 6U;
        }
        const float v28 = widowx_fs_max(0.0F, state->polar[0]);
        const float v29 = state->polar[1] - v28;

        if (v29 >= best) {
            best = v29;
            way = 2U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 3U;
        }
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 4U;
        }

        if (10.629795F >= best) {
            best = 10.629795F;
            way = 5U;
        }
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            goto team_27;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else if (way == 3U) {
            vertex = 0U;
            goto decided;
        } else if (way == 4U) {
            goto team_42;
        } else if (way == 5U) {
            goto team_38;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_27:
    {
        float best = -FLT_MAX;
        uint32_t way = 7U;
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 1U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 2U;
        }
        const float v86 = (-79.08088F) - state->polar[0];

        if (v86 >= best) {
            best = v86;
            way = 3U;
        }
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 4U;
        }
        const float v47 = 0.0F / state->polar[1];

        if (v47 >= best) {
            best = v47;
            way = 4U;
        }
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 5U;
        }

        if (13.937786F >= best) {
            best = 13.937786F;
            way = 6U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            way = 7U;
        }

        if (way == 1U) {
            goto team_42;
        } else if (way == 2U) {
            vertex = 0U;
            goto decided;
        } else if (way == 3U) {
            goto team_40;
        } else if (way == 4U) {
            vertex = 1U;
            goto decided;
        } else if (way == 5U) {
            goto team_28;
        } else if (way == 6U) {
            goto team_38;
        } else {
            goto team_30;
        }
    }

team_28:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 1U;
        }
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 2U;
        }
        const float v70 = state->polar[1] * (-107.57004F);

        if (v70 >= best) {
            best = v70;
            way = 3U;
        }
        const float v64 = state->polar[0] - 0.6354382F;

        if (v64 >= best) {
            best = v64;
            way = 4U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 5U;
        }
        const float v82 = 0.0F - state->polar[0];
        const float v83 = 2.710111F / v82;

        if (v83 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            goto team_42;
        } else if (way == 2U) {
            vertex = 4U;
            goto decided;
        } else if (way == 3U) {
            goto team_37;
        } else if (way == 4U) {
            goto team_29;
        } else if (way == 5U) {
            goto team_40;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_40:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;

        if (state->polar[2] >= best) {
            best = state->polar[2];
            way = 4U;
        }

        if (10.629795F >= best) {
            best = 10.629795F;
            way = 1U;
        }
        const float v28 = widowx_fs_max(0.0F, state->polar[0]);
        const float v29 = state->polar[1] - v28;

        if (v29 >= best) {
            best = v29;
            way = 2U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 3U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            goto team_41;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_29:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 1U;
        }
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            best = v4;
            way = 4U;
        }

        if (10.629795F >= best) {
            best = 10.629795F;
            way = 2U;
        }
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 3U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 4U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 5U;
        }
        const float v70 = state->polar[1] * (-107.57004F);

        if (v70 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            goto team_42;
        } else if (way == 2U) {
            goto team_38;
        } else if (way == 3U) {
            vertex = 4U;
            goto decided;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else if (way == 5U) {
            goto team_30;
        } else {
            goto team_37;
        }
    }

team_30:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 6U;
        }
        const float v64 = state->polar[0] - 0.6354382F;

        if (v64 >= best) {
            best = v64;
            way = 2U;
        }
        const float v65 = state->polar[0] + (-5.963282F);

        if (v65 >= best) {
            best = v65;
            way = 1U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 2U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 3U;
        }
        const float v41 = state->polar[2] * (-176.74728F);

        if (v41 >= best) {
            best = v41;
            way = 4U;
        }
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 5U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 4U;
            goto decided;
        } else if (way == 2U) {
            vertex = 0U;
            goto decided;
        } else if (way == 3U) {
            goto team_31;
        } else if (way == 4U) {
            goto team_41;
        } else if (way == 5U) {
            goto team_42;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_31:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v82 = 0.0F - state->polar[0];
        const float v83 = 2.710111F / v82;

        if (v83 >= best) {
            best = v83;
            way = 1U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 5U;
        }
        const float v27 = state->polar[1] / state->polar[1];

        if (v27 >= best) {
            best = v27;
            way = 2U;
        }
        const float v41 = state->polar[2] * (-176.74728F);
        const float v42 = v41 / state->polar[1];

        if (v42 >= best) {
            best = v42;
            way = 3U;
        }
        const float v64 = state->polar[0] - 0.6354382F;

        if (v64 >= best) {
            best = v64;
            way = 4U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 5U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 1U;
            goto decided;
        } else if (way == 2U) {
            goto team_39;
        } else if (way == 3U) {
            goto team_41;
        } else if (way == 4U) {
            goto team_34;
        } else if (way == 5U) {
            vertex = 0U;
            goto decided;
        } else {
            goto team_42;
        }
    }

team_36:
    {
        float best = 2.5843248F;
        uint32_t way = 1U;
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 2U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 3U;
        }

        if (state->polar[1] >= best) {
            way = 4U;
        }

        if (way == 1U) {
            goto team_39;
        } else if (way == 2U) {
            vertex = 1U;
            goto decided;
        } else if (way == 3U) {
            vertex = 0U;
            goto decided;
        } else {
            vertex = 3U;
            goto decided;
        }
    }

team_20:
    {
        float best = 10.629795F;
        uint32_t way = 1U;
        const float v80 = widowx_fs_min(state->polar[2], 110.01199F);

        if (v80 >= best) {
            best = v80;
            way = 2U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 5U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 3U;
        }
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 3U;
        }
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 4U;
        }
        const float v4 = state->polar[2] - 0.7582224F;

        if (v4 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            goto team_38;
        } else if (way == 2U) {
            goto team_21;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else if (way == 4U) {
            goto team_42;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_21:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v85 = widowx_fs_negate_if_less(state->polar[1], (-1.1606317F));

        if (v85 >= best) {
            best = v85;
            way = 1U;
        }

        if (15.754999F >= best) {
            best = 15.754999F;
            way = 2U;
        }
        const float v70 = state->polar[1] * (-107.57004F);

        if (v70 >= best) {
            best = v70;
            way = 3U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 4U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            goto team_22;
        } else if (way == 2U) {
            goto team_32;
        } else if (way == 3U) {
            goto team_37;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else {
            goto team_42;
        }
    }

team_37:
    {
        float best = -FLT_MAX;
        uint32_t way = 5U;
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 3U;
        }
        const float v64 = state->polar[0] - 0.6354382F;

        if (v64 >= best) {
            best = v64;
            way = 1U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 2U;
        }
        const float v43 = state->polar[2] + (-117.26495F);

        if (v43 >= best) {
            best = v43;
            way = 3U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 5U;
        }
        const float v72 = state->polar[0] * 0.87870044F;

        if (v72 >= best) {
            best = v72;
            way = 4U;
        }
        const float v28 = widowx_fs_max(0.0F, state->polar[0]);
        const float v29 = state->polar[1] - v28;

        if (v29 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            goto team_42;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else if (way == 4U) {
            goto team_41;
        } else {
            vertex = 3U;
            goto decided;
        }
    }

team_22:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v48 = (-107.57004F) / state->polar[0];

        if (v48 >= best) {
            best = v48;
            way = 4U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 1U;
        }

        if (15.754999F >= best) {
            best = 15.754999F;
            way = 2U;
        }
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 3U;
        }
        const float v43 = state->polar[2] + (-117.26495F);

        if (v43 >= best) {
            best = v43;
            way = 3U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            goto team_32;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else {
            goto team_42;
        }
    }

team_32:
    {
        float best = -FLT_MAX;
        uint32_t way = 6U;
        const float v72 = state->polar[0] * 0.87870044F;

        if (v72 >= best) {
            best = v72;
            way = 1U;
        }
        const float v73 = state->polar[2] * state->polar[0];
        const float v74 = v73 - state->polar[0];
        const float v75 = 2.710111F / v74;

        if (v75 >= best) {
            best = v75;
            way = 6U;
        }
        const float v76 = state->polar[0] + (-107.57004F);

        if (v76 >= best) {
            best = v76;
            way = 6U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 2U;
        }
        const float v27 = state->polar[1] / state->polar[1];

        if (v27 >= best) {
            best = v27;
            way = 4U;
        }
        const float v41 = state->polar[2] * (-176.74728F);
        const float v42 = v41 / state->polar[1];

        if (v42 >= best) {
            best = v42;
            way = 3U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 4U;
        }
        const float v64 = state->polar[0] - 0.6354382F;

        if (v64 >= best) {
            best = v64;
            way = 5U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 6U;
        }
        const float v78 = state->polar[0] * 0.18706028F;

        if (v78 >= best) {
            way = 6U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else if (way == 3U) {
            goto team_41;
        } else if (way == 4U) {
            goto team_39;
        } else if (way == 5U) {
            goto team_34;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_34:
    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v45 = state->polar[0] * (-79.08088F);

        if (v45 >= best) {
            best = v45;
            way = 4U;
        }
        const float v64 = state->polar[0] - 0.6354382F;

        if (v64 >= best) {
            best = v64;
            way = 1U;
        }

        if (15.754999F >= best) {
            best = 15.754999F;
            way = 2U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 3U;
        }
        const float v43 = state->polar[2] + (-117.26495F);

        if (v43 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            goto team_35;
        } else if (way == 3U) {
            goto team_42;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_35:
    {
        float best = 83.54613F;
        uint32_t way = 1U;
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 2U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            best = v18;
            way = 3U;
        }
        const float v73 = state->polar[2] * state->polar[0];
        const float v74 = v73 - state->polar[0];
        const float v75 = 2.710111F / v74;

        if (v75 >= best) {
            way = 3U;
        }

        if (way == 1U) {
            goto team_41;
        } else if (way == 2U) {
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
        uint32_t way = 5U;
        const float v40 = state->polar[0] / 0.6354382F;

        if (v40 >= best) {
            best = v40;
            way = 4U;
        }
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 4U;
        }
        const float v41 = state->polar[2] * (-176.74728F);
        const float v42 = v41 / state->polar[1];

        if (v42 >= best) {
            best = v42;
            way = 1U;
        }

        if (2.5843248F >= best) {
            best = 2.5843248F;
            way = 2U;
        }
        const float v43 = state->polar[2] + (-117.26495F);

        if (v43 >= best) {
            best = v43;
            way = 3U;
        }

        if (state->polar[0] >= best) {
            best = state->polar[0];
            way = 4U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            way = 5U;
        }

        if (way == 1U) {
            goto team_41;
        } else if (way == 2U) {
            goto team_39;
        } else if (way == 3U) {
            vertex = 1U;
            goto decided;
        } else if (way == 4U) {
            vertex = 0U;
            goto decided;
        } else {
            goto team_42;
        }
    }

team_42:
    {
        float best = -FLT_MAX;
        uint32_t way = 3U;
        const float v47 = 0.0F / state->polar[1];

        if (v47 >= best) {
            best = v47;
            way = 3U;
        }

        if (state->polar[0] >= best) {
            best = state->polar[0];
            way = 1U;
        }
        const float v7 = widowx_fs_min((-8.893463F), state->polar[1]);

        if (v7 >= best) {
            best = v7;
            way = 1U;
        }

        if (state->polar[1] >= best) {
            best = state->polar[1];
            way = 2U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
            way = 3U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            vertex = 3U;
            goto decided;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

team_39:
    {
        float best = -FLT_MAX;
        uint32_t way = 3U;
        const float v58 = widowx_fs_max(state->polar[1], 0.0F);
        const float v59 = fabsf(v58);

        if (v59 >= best) {
            best = v59;
            way = 1U;
        }
        const float v60 = widowx_fs_min(state->polar[0], state->polar[1]);

        if (v60 >= best) {
            best = v60;
            way = 2U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            way = 3U;
        }

        if (way == 1U) {
            vertex = 6U;
            goto decided;
        } else if (way == 2U) {
            vertex = 0U;
            goto decided;
        } else {
            vertex = 5U;
            goto decided;
        }
    }

team_41:
    {
        const volatile float constant = 0.0F;
        const float zero = constant;
        float best = zero;
        uint32_t way = 1U;
        const float v10 = state->polar[0] - 0.7582224F;

        if (v10 >= best) {
            best = v10;
            way = 2U;
        }
        const float v67 = state->polar[1] * (-55.687565F);

        if (v67 >= best) {
            best = v67;
            way = 3U;
        }
        const float v18 = state->polar[0] * (-107.57004F);

        if (v18 >= best) {
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

decided:
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
