/*
 * A policy for the WidowX arm from its home pose, 98.7 % success in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_fs --profile fast
 * Graph SHA-256: e6794520ca2e312cdd2e5882de94ac2dc889564793be68cfa3b4c3c8774c71d2
 * 31 teams (18 on the longest walk), 188 edges, 153 programs, 52 distinct operations.
 * A decision takes at most 113 bids and 108 operations.
 * Computes in f32 with own maths.
 */
#include "widowx_fs.h"

#include <float.h>
#include <math.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "fast-math, or a part of it, reorders operations: the policy would act differently"
#endif
#if defined(__FINITE_MATH_ONLY__) && (__FINITE_MATH_ONLY__ > 0)
#error "-ffinite-math-only drops NaN and infinities: the policy would act differently"
#endif
/* 16 only widens types narrower than float. */
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
#if defined(__clang_major__) && (__clang_major__ >= 13) /* no macro reveals -fassociative-math */
#pragma clang fp reassociate(off)
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

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
widowx_fs_action_t widowx_fs_infer(const widowx_fs_state_t *state)
{
    {
        float best = 107.35707f;
        uint32_t next = 1U;
        const float elbow_up = state->polar[2] - 0.7582224f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 3U;
        }

        const float to_team_9 = 0.0f - state->polar[1];
        if (to_team_9 >= best) {
            best = to_team_9;
            next = 2U;
        }

        const float elbow_up_2 = elbow_up / 0.0f / 0.0f;
        if (elbow_up_2 >= best) {
            best = elbow_up_2;
            next = 3U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            next = 4U;
        }

        if (next == 2U) {
            goto team_9;
        }
        if (next == 3U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 4U) {
            return WIDOWX_FS_BASE_UP;
        }
    }

    {
        float best = 1.6245565f;
        uint32_t next = 1U;
        const float base_up = 0.0f * state->polar[2];
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        const float base_up_2 = widowx_fs_negate_if_less(state->polar[0], 0.0f);
        if (base_up_2 >= best) {
            best = base_up_2;
            next = 4U;
        }

        const float to_team_9 = 0.0f - state->polar[1];
        if (to_team_9 >= best) {
            best = to_team_9;
            next = 2U;
        }

        const float base_down = -107.57004f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float base_up_3 = state->polar[0] - 0.7582224f;
        if (base_up_3 >= best) {
            best = base_up_3;
            next = 4U;
        }

        const float to_team_10 = -176.74728f * state->polar[1] - 0.52844894f;
        if (to_team_10 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            goto team_7;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 4U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 5U) {
            goto team_10;
        }
    }

team_9:
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float to_team_12 = -176.74728f * state->polar[1] - 0.52844894f;
        if (to_team_12 >= best) {
            best = to_team_12;
            next = 1U;
        }

        const float elbow_up = state->polar[2] - 0.7582224f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 3U;
        }

        if (20.1483f >= best) {
            best = 20.1483f;
            next = 2U;
        }

        const float elbow_up_2 = state->polar[2] + elbow_up;
        if (elbow_up_2 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            goto team_12;
        }
        if (next == 2U) {
            goto team_11;
        }
        return WIDOWX_FS_ELBOW_UP;
    }

team_7:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float base_up = 0.7582224f * state->polar[0];
        if (base_up >= best) {
            best = base_up;
            next = 5U;
        }

        const float base_down = -107.57004f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 1U;
        }

        const float shoulder_down = 42.029076f / state->polar[1];
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 2U;
        }

        const float to_team_10 = -176.74728f * state->polar[1] - 0.52844894f;
        if (to_team_10 >= best) {
            best = to_team_10;
            next = 3U;
        }

        if (3.135279f >= best) {
            best = 3.135279f;
            next = 4U;
        }

        const float base_up_2 = state->polar[0] - 0.7582224f;
        if (base_up_2 >= best) {
            best = base_up_2;
            next = 5U;
        }

        const float elbow_up = (state->polar[2] - 0.7582224f) / 0.0f;
        if (elbow_up >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 2U) {
            return WIDOWX_FS_SHOULDER_DOWN;
        }
        if (next == 4U) {
            goto team_13;
        }
        if (next == 5U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 6U) {
            return WIDOWX_FS_ELBOW_UP;
        }
    }

team_10:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float to_team_12 = -176.74728f * state->polar[1] - 0.52844894f;
        if (to_team_12 >= best) {
            best = to_team_12;
            next = 1U;
        }

        const float to_team_23 = -107.57004f / state->polar[2];
        if (to_team_23 >= best) {
            best = to_team_23;
            next = 2U;
        }

        const float elbow_up = state->polar[2] - 0.7582224f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 3U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        const float base_down = -107.57004f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 6U;
        }

        const float base_down_2 = 0.0f / state->polar[1];
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 6U;
        }

        if (20.1483f >= best) {
            best = 20.1483f;
            next = 5U;
        }

        const float base_down_3 = -79.08088f * state->polar[0];
        if (base_down_3 >= best) {
            next = 6U;
        }

        if (next == 1U) {
            goto team_12;
        }
        if (next == 2U) {
            goto team_23;
        }
        if (next == 3U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 4U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 6U) {
            return WIDOWX_FS_BASE_DOWN;
        }
    }

team_11:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float elbow_up = state->polar[2] - 0.7582224f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 1U;
        }

        const float elbow_up_2 = state->polar[2] - 0.75724316f;
        if (elbow_up_2 >= best) {
            best = elbow_up_2;
            next = 1U;
        }

        const float elbow_up_3 = state->polar[2] - 117.26495f;
        if (elbow_up_3 >= best) {
            best = elbow_up_3;
            next = 1U;
        }

        if (1.6245565f >= best) {
            best = 1.6245565f;
            next = 2U;
        }

        const float base_up = state->polar[0] - 0.7258825f;
        if (base_up >= best) {
            best = base_up;
            next = 5U;
        }

        const float base_down = -79.08088f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float to_team_30 = -107.57004f * state->polar[0];
        if (to_team_30 >= best) {
            best = to_team_30;
            next = 4U;
        }

        const float base_up_2 = state->polar[0] - 0.7582224f;
        if (base_up_2 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 2U) {
            goto team_15;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 4U) {
            goto team_30;
        }
        return WIDOWX_FS_BASE_UP;
    }

team_12:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float to_team_20 = -117.26495f - state->polar[2];
        if (to_team_20 >= best) {
            best = to_team_20;
            next = 1U;
        }

        const float elbow_up = state->polar[0] - 117.26495f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 4U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 2U;
        }

        const float to_team_36 = -107.57004f * state->polar[0];
        if (to_team_36 >= best) {
            best = to_team_36;
            next = 3U;
        }

        const float elbow_up_2 = state->polar[2] - 0.7582224f;
        if (elbow_up_2 >= best) {
            best = elbow_up_2;
            next = 4U;
        }

        if (26.139645f >= best) {
            next = 5U;
        }

        if (next == 1U) {
            goto team_20;
        }
        if (next == 2U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 3U) {
            goto team_36;
        }
        if (next == 4U) {
            return WIDOWX_FS_ELBOW_UP;
        }
    }

team_13:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float elbow_up = state->polar[2] - 0.7582224f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 1U;
        }

        const float to_team_30 = -107.57004f * state->polar[0];
        if (to_team_30 >= best) {
            best = to_team_30;
            next = 2U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 6U;
        }

        if (1.6245565f >= best) {
            best = 1.6245565f;
            next = 3U;
        }

        const float to_team_39 = state->polar[1] / state->polar[1];
        if (to_team_39 >= best) {
            best = to_team_39;
            next = 4U;
        }

        const float shoulder_down = state->polar[1] - widowx_fs_max(0.0f, state->polar[0]);
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 5U;
        }

        const float base_up_2 = state->polar[0] - 1.0168722f;
        if (base_up_2 >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 2U) {
            goto team_30;
        }
        if (next == 4U) {
            goto team_39;
        }
        if (next == 5U) {
            return WIDOWX_FS_SHOULDER_DOWN;
        }
        if (next == 6U) {
            return WIDOWX_FS_BASE_UP;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float elbow_up = state->polar[2] - 0.7582224f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 1U;
        }

        const float to_team_30 = -107.57004f * state->polar[0];
        if (to_team_30 >= best) {
            best = to_team_30;
            next = 2U;
        }

        const float to_team_24 = state->polar[1] / 0.0f;
        if (to_team_24 >= best) {
            best = to_team_24;
            next = 3U;
        }

        if (1.6245565f >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 2U) {
            goto team_30;
        }
        if (next == 3U) {
            goto team_24;
        }
    }

team_15:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_23 = -107.57004f / state->polar[0];
        if (to_team_23 >= best) {
            best = to_team_23;
            next = 1U;
        }

        const float shoulder_up = state->polar[2] - 0.7582224f;
        const float elbow_up = widowx_fs_max(state->polar[2], shoulder_up);
        if (elbow_up >= best) {
            best = elbow_up;
            next = 2U;
        }

        if (shoulder_up >= best) {
            best = shoulder_up;
            next = 3U;
        }

        if (INFINITY >= best) {
            next = 4U;
        }

        if (next == 1U) {
            goto team_23;
        }
        if (next == 2U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 3U) {
            return WIDOWX_FS_SHOULDER_UP;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float shoulder_up = state->polar[2] + 6.7057414f;
        if (shoulder_up >= best) {
            best = shoulder_up;
            next = 4U;
        }

        if (6.543999f >= best) {
            best = 6.543999f;
            next = 1U;
        }

        const float to_team_24 = state->polar[1] / 0.0f;
        if (to_team_24 >= best) {
            best = to_team_24;
            next = 2U;
        }

        const float base_down = -79.08088f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 5U;
        }

        const float to_team_42 = -107.57004f / state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 3U;
        }

        const float shoulder_up_2 = state->polar[2] - 0.7582224f;
        if (shoulder_up_2 >= best) {
            best = shoulder_up_2;
            next = 4U;
        }

        const float base_down_2 = -107.57004f * state->polar[0];
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 5U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_FS_WRIST_DOWN;
        }
        if (next == 2U) {
            goto team_24;
        }
        if (next == 3U) {
            goto team_42;
        }
        if (next == 4U) {
            return WIDOWX_FS_SHOULDER_UP;
        }
        if (next == 5U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        return WIDOWX_FS_BASE_UP;
    }

team_23:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float elbow_up = state->polar[2] - 0.7582224f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 1U;
        }

        const float to_team_38 = widowx_fs_negate_if_less(state->polar[1], 229.17769f);
        if (to_team_38 >= best) {
            best = to_team_38;
            next = 2U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 3U;
        }

        const float to_team_37 = -107.57004f * state->polar[1];
        if (to_team_37 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 2U) {
            goto team_38;
        }
        if (next == 4U) {
            goto team_37;
        }
    }

team_24:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float to_team_27 = state->polar[2] - 0.7582224f;
        if (to_team_27 >= best) {
            best = to_team_27;
            next = 1U;
        }

        const float to_team_38 = widowx_fs_negate_if_less(state->polar[1], 229.17769f);
        if (to_team_38 >= best) {
            best = to_team_38;
            next = 5U;
        }

        const float base_down = state->polar[2] - 117.26495f;
        if (base_down >= best) {
            best = base_down;
            next = 6U;
        }

        const float shoulder_down = state->polar[1] - widowx_fs_max(0.0f, state->polar[0]);
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 2U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 3U;
        }

        const float to_team_42 = -107.57004f / state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 4U;
        }

        if (10.629795f >= best) {
            best = 10.629795f;
            next = 5U;
        }

        const float base_down_2 = -79.08088f * state->polar[0];
        if (base_down_2 >= best) {
            next = 6U;
        }

        if (next == 2U) {
            return WIDOWX_FS_SHOULDER_DOWN;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 4U) {
            goto team_42;
        }
        if (next == 5U) {
            goto team_38;
        }
        if (next == 6U) {
            return WIDOWX_FS_BASE_DOWN;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 7U;
        const float to_team_42 = -107.57004f / state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 1U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 2U;
        }

        const float to_team_40 = -79.08088f - state->polar[0];
        if (to_team_40 >= best) {
            best = to_team_40;
            next = 3U;
        }

        const float base_down = -79.08088f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 4U;
        }

        const float base_down_2 = 0.0f / state->polar[1];
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 4U;
        }

        const float to_team_28 = state->polar[2] - 0.7582224f;
        if (to_team_28 >= best) {
            best = to_team_28;
            next = 5U;
        }

        if (13.937786f >= best) {
            best = 13.937786f;
            next = 6U;
        }

        const float to_team_30 = -107.57004f * state->polar[0];
        if (to_team_30 >= best) {
            next = 7U;
        }

        if (next == 1U) {
            goto team_42;
        }
        if (next == 2U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 3U) {
            goto team_40;
        }
        if (next == 4U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 6U) {
            goto team_38;
        }
        if (next == 7U) {
            goto team_30;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float to_team_42 = -107.57004f / state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 1U;
        }

        const float elbow_up = state->polar[2] - 0.7582224f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 2U;
        }

        const float to_team_37 = -107.57004f * state->polar[1];
        if (to_team_37 >= best) {
            best = to_team_37;
            next = 3U;
        }

        const float to_team_29 = state->polar[0] - 0.6354382f;
        if (to_team_29 >= best) {
            best = to_team_29;
            next = 4U;
        }

        const float to_team_40 = -107.57004f * state->polar[0];
        if (to_team_40 >= best) {
            best = to_team_40;
            next = 5U;
        }

        const float base_down = 2.710111f / (0.0f - state->polar[0]);
        if (base_down >= best) {
            next = 6U;
        }

        if (next == 1U) {
            goto team_42;
        }
        if (next == 2U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 3U) {
            goto team_37;
        }
        if (next == 4U) {
            goto team_29;
        }
        if (next == 6U) {
            return WIDOWX_FS_BASE_DOWN;
        }
    }

team_40:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        if (state->polar[2] >= best) {
            best = state->polar[2];
            next = 4U;
        }

        if (10.629795f >= best) {
            best = 10.629795f;
            next = 1U;
        }

        const float shoulder_down = state->polar[1] - widowx_fs_max(0.0f, state->polar[0]);
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 2U;
        }

        const float base_down = -107.57004f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float base_up_2 = state->polar[0] - 0.7582224f;
        if (base_up_2 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            goto team_41;
        }
        if (next == 2U) {
            return WIDOWX_FS_SHOULDER_DOWN;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        return WIDOWX_FS_BASE_UP;
    }

team_29:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float to_team_42 = -107.57004f / state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 1U;
        }

        const float base_up = state->polar[2] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        if (10.629795f >= best) {
            best = 10.629795f;
            next = 2U;
        }

        const float elbow_up = -79.08088f * state->polar[0];
        if (elbow_up >= best) {
            best = elbow_up;
            next = 3U;
        }

        const float base_up_2 = state->polar[0] - 0.7582224f;
        if (base_up_2 >= best) {
            best = base_up_2;
            next = 4U;
        }

        const float to_team_30 = -107.57004f * state->polar[0];
        if (to_team_30 >= best) {
            best = to_team_30;
            next = 5U;
        }

        const float to_team_37 = -107.57004f * state->polar[1];
        if (to_team_37 >= best) {
            next = 6U;
        }

        if (next == 1U) {
            goto team_42;
        }
        if (next == 2U) {
            goto team_38;
        }
        if (next == 3U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 4U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 6U) {
            goto team_37;
        }
    }

team_30:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float base_down = -79.08088f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 6U;
        }

        const float base_up = state->polar[0] - 0.6354382f;
        if (base_up >= best) {
            best = base_up;
            next = 2U;
        }

        const float elbow_up = state->polar[0] - 5.963282f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 1U;
        }

        const float base_up_2 = state->polar[0] - 0.7582224f;
        if (base_up_2 >= best) {
            best = base_up_2;
            next = 2U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 3U;
        }

        const float to_team_41 = -176.74728f * state->polar[2];
        if (to_team_41 >= best) {
            best = to_team_41;
            next = 4U;
        }

        const float to_team_42 = -107.57004f / state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 5U;
        }

        const float base_down_2 = -107.57004f * state->polar[0];
        if (base_down_2 >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_FS_ELBOW_UP;
        }
        if (next == 2U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 4U) {
            goto team_41;
        }
        if (next == 5U) {
            goto team_42;
        }
        if (next == 6U) {
            return WIDOWX_FS_BASE_DOWN;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float base_down = 2.710111f / (0.0f - state->polar[0]);
        if (base_down >= best) {
            best = base_down;
            next = 1U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 5U;
        }

        const float to_team_39 = state->polar[1] / state->polar[1];
        if (to_team_39 >= best) {
            best = to_team_39;
            next = 2U;
        }

        const float to_team_41 = -176.74728f * state->polar[2] / state->polar[1];
        if (to_team_41 >= best) {
            best = to_team_41;
            next = 3U;
        }

        const float to_team_34 = state->polar[0] - 0.6354382f;
        if (to_team_34 >= best) {
            best = to_team_34;
            next = 4U;
        }

        const float base_up_2 = state->polar[0] - 0.7582224f;
        if (base_up_2 >= best) {
            best = base_up_2;
            next = 5U;
        }

        const float to_team_42 = -107.57004f * state->polar[0];
        if (to_team_42 >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 2U) {
            goto team_39;
        }
        if (next == 3U) {
            goto team_41;
        }
        if (next == 4U) {
            goto team_34;
        }
        if (next == 5U) {
            return WIDOWX_FS_BASE_UP;
        }
        goto team_42;
    }

team_36:
    {
        float best = 2.5843248f;
        uint32_t next = 1U;
        const float base_down = -107.57004f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 2U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 3U;
        }

        if (state->polar[1] >= best) {
            next = 4U;
        }

        if (next == 1U) {
            goto team_39;
        }
        if (next == 2U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_UP;
        }
        return WIDOWX_FS_SHOULDER_DOWN;
    }

team_20:
    {
        float best = 10.629795f;
        uint32_t next = 1U;
        const float to_team_21 = widowx_fs_min(state->polar[2], 110.01199f);
        if (to_team_21 >= best) {
            best = to_team_21;
            next = 2U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 5U;
        }

        const float base_down = -107.57004f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float base_down_2 = -79.08088f * state->polar[0];
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 3U;
        }

        const float to_team_42 = -107.57004f / state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 4U;
        }

        const float base_up_2 = state->polar[2] - 0.7582224f;
        if (base_up_2 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            goto team_38;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 4U) {
            goto team_42;
        }
        if (next == 5U) {
            return WIDOWX_FS_BASE_UP;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float to_team_22 = widowx_fs_negate_if_less(state->polar[1], -1.1606317f);
        if (to_team_22 >= best) {
            best = to_team_22;
            next = 1U;
        }

        if (15.754999f >= best) {
            best = 15.754999f;
            next = 2U;
        }

        const float to_team_37 = -107.57004f * state->polar[1];
        if (to_team_37 >= best) {
            best = to_team_37;
            next = 3U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        const float to_team_42 = -107.57004f * state->polar[0];
        if (to_team_42 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            goto team_22;
        }
        if (next == 2U) {
            goto team_32;
        }
        if (next == 4U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 5U) {
            goto team_42;
        }
    }

team_37:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float base_down = -79.08088f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float base_up = state->polar[0] - 0.6354382f;
        if (base_up >= best) {
            best = base_up;
            next = 1U;
        }

        const float to_team_42 = -107.57004f * state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 2U;
        }

        const float base_down_2 = state->polar[2] - 117.26495f;
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 3U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 5U;
        }

        const float to_team_41 = 0.87870044f * state->polar[0];
        if (to_team_41 >= best) {
            best = to_team_41;
            next = 4U;
        }

        const float shoulder_down_2 = state->polar[1] - widowx_fs_max(0.0f, state->polar[0]);
        if (shoulder_down_2 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 2U) {
            goto team_42;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 4U) {
            goto team_41;
        }
        return WIDOWX_FS_SHOULDER_DOWN;
    }

team_22:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_42 = -107.57004f / state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 4U;
        }

        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 1U;
        }

        if (15.754999f >= best) {
            best = 15.754999f;
            next = 2U;
        }

        const float base_down = -79.08088f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float base_down_2 = state->polar[2] - 117.26495f;
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 3U;
        }

        const float to_team_42_2 = -107.57004f * state->polar[0];
        if (to_team_42_2 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 4U) {
            goto team_42;
        }
    }

team_32:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float base_up = 0.87870044f * state->polar[0];
        if (base_up >= best) {
            best = base_up;
            next = 1U;
        }

        const float base_down = 2.710111f / (state->polar[2] * state->polar[0] - state->polar[0]);
        if (base_down >= best) {
            best = base_down;
            next = 6U;
        }

        const float base_down_2 = state->polar[0] - 107.57004f;
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 6U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 2U;
        }

        const float to_team_39 = state->polar[1] / state->polar[1];
        if (to_team_39 >= best) {
            best = to_team_39;
            next = 4U;
        }

        const float to_team_41 = -176.74728f * state->polar[2] / state->polar[1];
        if (to_team_41 >= best) {
            best = to_team_41;
            next = 3U;
        }

        const float to_team_39_2 = state->polar[0] - 0.7582224f;
        if (to_team_39_2 >= best) {
            best = to_team_39_2;
            next = 4U;
        }

        const float to_team_34 = state->polar[0] - 0.6354382f;
        if (to_team_34 >= best) {
            best = to_team_34;
            next = 5U;
        }

        const float base_down_3 = -107.57004f * state->polar[0];
        if (base_down_3 >= best) {
            best = base_down_3;
            next = 6U;
        }

        const float base_down_4 = 0.18706028f * state->polar[0];
        if (base_down_4 >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 2U) {
            return WIDOWX_FS_SHOULDER_DOWN;
        }
        if (next == 3U) {
            goto team_41;
        }
        if (next == 4U) {
            goto team_39;
        }
        if (next == 6U) {
            return WIDOWX_FS_BASE_DOWN;
        }
    }

team_34:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float base_down = -79.08088f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 4U;
        }

        const float base_up = state->polar[0] - 0.6354382f;
        if (base_up >= best) {
            best = base_up;
            next = 1U;
        }

        if (15.754999f >= best) {
            best = 15.754999f;
            next = 2U;
        }

        const float to_team_42 = -107.57004f * state->polar[0];
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 3U;
        }

        const float base_down_2 = state->polar[2] - 117.26495f;
        if (base_down_2 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return WIDOWX_FS_BASE_UP;
        }
        if (next == 3U) {
            goto team_42;
        }
        if (next == 4U) {
            return WIDOWX_FS_BASE_DOWN;
        }
    }

    {
        float best = 83.54613f;
        uint32_t next = 1U;
        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            next = 2U;
        }

        const float base_down = -107.57004f * state->polar[0];
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float base_down_2 = 2.710111f / (state->polar[2] * state->polar[0] - state->polar[0]);
        if (base_down_2 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            goto team_41;
        }
        if (next == 2U) {
            return WIDOWX_FS_BASE_UP;
        }
        return WIDOWX_FS_BASE_DOWN;
    }

team_38:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float base_up = state->polar[0] / 0.6354382f;
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        const float base_up_2 = state->polar[0] - 0.7582224f;
        if (base_up_2 >= best) {
            best = base_up_2;
            next = 4U;
        }

        const float to_team_41 = -176.74728f * state->polar[2] / state->polar[1];
        if (to_team_41 >= best) {
            best = to_team_41;
            next = 1U;
        }

        if (2.5843248f >= best) {
            best = 2.5843248f;
            next = 2U;
        }

        const float base_down = state->polar[2] - 117.26495f;
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        if (state->polar[0] >= best) {
            best = state->polar[0];
            next = 4U;
        }

        const float to_team_42 = -107.57004f * state->polar[0];
        if (to_team_42 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            goto team_41;
        }
        if (next == 2U) {
            goto team_39;
        }
        if (next == 3U) {
            return WIDOWX_FS_BASE_DOWN;
        }
        if (next == 4U) {
            return WIDOWX_FS_BASE_UP;
        }
    }

team_42:
    {
        float best = -FLT_MAX;
        widowx_fs_action_t action = WIDOWX_FS_BASE_DOWN;
        const float base_down = 0.0f / state->polar[1];
        if (base_down >= best) {
            best = base_down;
            action = WIDOWX_FS_BASE_DOWN;
        }

        if (state->polar[0] >= best) {
            best = state->polar[0];
            action = WIDOWX_FS_BASE_UP;
        }

        const float base_up_2 = widowx_fs_min(-8.893463f, state->polar[1]);
        if (base_up_2 >= best) {
            best = base_up_2;
            action = WIDOWX_FS_BASE_UP;
        }

        if (state->polar[1] >= best) {
            best = state->polar[1];
            action = WIDOWX_FS_SHOULDER_DOWN;
        }

        const float base_down_2 = -107.57004f * state->polar[0];
        if (base_down_2 >= best) {
            action = WIDOWX_FS_BASE_DOWN;
        }

        return action;
    }

team_39:
    {
        float best = -FLT_MAX;
        widowx_fs_action_t action = WIDOWX_FS_ELBOW_DOWN;
        const float wrist_up = fabsf(widowx_fs_max(state->polar[1], 0.0f));
        if (wrist_up >= best) {
            best = wrist_up;
            action = WIDOWX_FS_WRIST_UP;
        }

        const float base_up = widowx_fs_min(state->polar[0], state->polar[1]);
        if (base_up >= best) {
            best = base_up;
            action = WIDOWX_FS_BASE_UP;
        }

        if (0.0f >= best) {
            action = WIDOWX_FS_ELBOW_DOWN;
        }

        return action;
    }

team_41:
    {
        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        float best = zero;
        widowx_fs_action_t action = WIDOWX_FS_SHOULDER_DOWN;
        const float base_up = state->polar[0] - 0.7582224f;
        if (base_up >= best) {
            best = base_up;
            action = WIDOWX_FS_BASE_UP;
        }

        const float elbow_down = -55.687565f * state->polar[1];
        if (elbow_down >= best) {
            best = elbow_down;
            action = WIDOWX_FS_ELBOW_DOWN;
        }

        const float base_down = -107.57004f * state->polar[0];
        if (base_down >= best) {
            action = WIDOWX_FS_BASE_DOWN;
        }

        return action;
    }
}

#ifndef WIDOWX_FS_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t widowx_fs_arithmetic(void)
{
    const volatile float numbers[6] = { 0.0f, FLT_MAX, 1.0002441f, 16777216.0f, 41.0f, FLT_MIN };
    const float zero = numbers[0];
    const float most = numbers[1];
    const float near_one = numbers[2];
    const float large = numbers[3];
    const float dividend = numbers[4];
    const float smallest = numbers[5];
    const float infinite = most + most;
    const float nan = infinite * zero;
    const float fused = (near_one * near_one) - 1.0004883f;
    const float reordered = (large + 1.0f) - large;
    const float quotient = dividend / 41.0f;
    uint32_t wrong = 0U;

    wrong += ((nan >= zero) || (nan <= zero)) ? 1U : 0U;
    wrong += (infinite > FLT_MAX) ? 0U : 1U;
    wrong += (fused > zero) ? 1U : 0U;
    wrong += (reordered > zero) ? 1U : 0U;
    wrong += (quotient < 1.0f) ? 1U : 0U;
    wrong += ((smallest * 0.5f) > zero) ? 0U : 1U;
    return wrong;
}

uint32_t widowx_fs_selftest(void)
{
    static const widowx_fs_state_t states[24] = {
        { { -87.56787f, -376.81543f, 86.711044f } },
        { { -252.04652f, -194.24585f, 189.12798f } },
        { { -34.94282f, -311.91788f, 336.5534f } },
        { { 185.54842f, -15.035073f, 69.33381f } },
        { { 344.07086f, -313.66815f, 0.75822246f } },
        { { -0.015102314f, 6.7071295f, -90.75621f } },
        { { 2.3827791f, -46.5493f, -78.47652f } },
        { { 2.382779f, -46.5493f, -78.47652f } },
        { { 344.07086f, -313.66815f, 0.7582224f } },
        { { 129.0018f, -163.81705f, 0.7582224f } },
        { { 129.0018f, -163.81705f, 0.75822246f } },
        { { -207.84515f, 248.81186f, 0.75822246f } },
        { { -207.84515f, 248.81186f, 0.7582224f } },
        { { -277.7295f, 227.08527f, 0.7582224f } },
        { { -277.7295f, 227.08527f, 0.75822246f } },
        { { -130.9661f, 246.20493f, 0.75822246f } },
        { { -130.9661f, 246.20493f, 0.7582224f } },
        { { 89.127884f, 36.226364f, 0.7582224f } },
        { { 89.127884f, 36.226364f, 0.75822246f } },
        { { -88.368454f, -6.1471615f, 0.75822246f } },
        { { -88.368454f, -6.1471615f, 0.7582224f } },
        { { -0.015102315f, 6.7071295f, -90.75621f } },
        { { -98.78519f, 141.60703f, 0.75822246f } },
        { { -98.78519f, 141.60703f, 0.7582224f } },
    };
    static const widowx_fs_action_t actions[24] = {
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_SHOULDER_DOWN,
        WIDOWX_FS_BASE_UP,
        WIDOWX_FS_WRIST_DOWN,
        WIDOWX_FS_BASE_UP,
        WIDOWX_FS_BASE_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_BASE_DOWN,
        WIDOWX_FS_BASE_DOWN,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_BASE_DOWN,
        WIDOWX_FS_BASE_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_BASE_DOWN,
        WIDOWX_FS_BASE_DOWN,
        WIDOWX_FS_ELBOW_UP,
        WIDOWX_FS_BASE_DOWN,
    };
    uint32_t failures = widowx_fs_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (widowx_fs_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
