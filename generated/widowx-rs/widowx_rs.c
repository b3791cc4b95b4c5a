/*
 * A policy for the WidowX arm from any pose, 97.4 % success in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix widowx_rs --profile fast
 * Graph SHA-256: c354d98892012e8559994649b02ad2e36c193c87e20be9aacffa833615cf752b
 * 30 teams (16 on the longest walk), 210 edges, 156 programs, 56 distinct operations.
 * A decision takes at most 118 bids and 118 operations.
 * Computes in f32 with own maths.
 */
#include "widowx_rs.h"

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

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
widowx_rs_action_t widowx_rs_infer(const widowx_rs_state_t *state)
{
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float elbow_down = state->stance[1] / 9.539528f;
        if (elbow_down >= best) {
            best = elbow_down;
            next = 1U;
        }

        const float to_team_7 = state->stance[0] / 0.0f;
        if (to_team_7 >= best) {
            best = to_team_7;
            next = 2U;
        }

        const float to_team_44 = state->stance[1] - 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 3U;
        }

        const float to_team_5 = fabsf(state->stance[2]);
        if (to_team_5 >= best) {
            best = to_team_5;
            next = 4U;
        }

        const float wrist_up = 164.8815f * state->stance[3];
        if (wrist_up >= best) {
            best = wrist_up;
            next = 5U;
        }

        if (0.0f >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_RS_ELBOW_DOWN;
        }
        if (next == 2U) {
            goto team_7;
        }
        if (next == 3U) {
            goto team_44;
        }
        if (next == 5U) {
            return WIDOWX_RS_WRIST_UP;
        }
        if (next == 6U) {
            return WIDOWX_RS_SHOULDER_UP;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float to_team_10 = -6.3484564f * state->stance[3];
        if (to_team_10 >= best) {
            best = to_team_10;
            next = 3U;
        }

        const float wrist_up = widowx_rs_max(state->stance[2], -3.385455f);
        if (wrist_up >= best) {
            best = wrist_up;
            next = 5U;
        }

        const float to_team_7 = state->stance[0] / 0.0f;
        if (to_team_7 >= best) {
            best = to_team_7;
            next = 1U;
        }

        const float base_down = (-3.3748567f - state->stance[0]) * state->floor;
        if (base_down >= best) {
            best = base_down;
            next = 2U;
        }

        const float to_team_10_2 = -6.3484564f - state->stance[3];
        if (to_team_10_2 >= best) {
            best = to_team_10_2;
            next = 3U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 4U;
        }

        const float wrist_up_2 = -3.3748567f - state->floor;
        if (wrist_up_2 >= best) {
            best = wrist_up_2;
            next = 5U;
        }

        const float wrist_up_3 = 164.8815f * state->stance[3];
        if (wrist_up_3 >= best) {
            best = wrist_up_3;
            next = 5U;
        }

        const float wrist_up_4 = state->stance[1] / 11.184899f;
        if (wrist_up_4 >= best) {
            next = 5U;
        }

        if (next == 2U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 3U) {
            goto team_10;
        }
        if (next == 4U) {
            goto team_44;
        }
        if (next == 5U) {
            return WIDOWX_RS_WRIST_UP;
        }
    }

team_7:
    {
        float best = -FLT_MAX;
        uint32_t next = 8U;
        const float wrist_up = -3.3748567f - state->floor;
        if (wrist_up >= best) {
            best = wrist_up;
            next = 1U;
        }

        const float to_team_44 = state->stance[1] - 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 2U;
        }

        const float to_team_11 = -10.533181f - state->floor;
        if (to_team_11 >= best) {
            best = to_team_11;
            next = 3U;
        }

        const float base_down = 0.0f - state->floor;
        if (base_down >= best) {
            best = base_down;
            next = 6U;
        }

        const float elbow_up = widowx_rs_max(-161.71835f, state->stance[2]);
        if (elbow_up >= best) {
            best = elbow_up;
            next = 4U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 5U;
        }

        const float base_down_2 = (-3.3748567f - state->stance[0]) * state->floor;
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 6U;
        }

        const float to_team_10 = -6.3484564f * state->stance[3];
        if (to_team_10 >= best) {
            best = to_team_10;
            next = 7U;
        }

        const float to_team_13 = state->stance[3] / state->floor;
        if (to_team_13 >= best) {
            next = 8U;
        }

        if (next == 1U) {
            return WIDOWX_RS_WRIST_UP;
        }
        if (next == 2U) {
            goto team_44;
        }
        if (next == 3U) {
            goto team_11;
        }
        if (next == 4U) {
            return WIDOWX_RS_ELBOW_UP;
        }
        if (next == 5U) {
            return WIDOWX_RS_ELBOW_DOWN;
        }
        if (next == 6U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 8U) {
            goto team_13;
        }
    }

team_10:
    {
        float best = -FLT_MAX;
        uint32_t next = 7U;
        const float elbow_up = state->stance[1] / 11.184899f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 1U;
        }

        const float to_team_32 = state->stance[1] - 9.689877f;
        if (to_team_32 >= best) {
            best = to_team_32;
            next = 2U;
        }

        if (24.873356f >= best) {
            best = 24.873356f;
            next = 3U;
        }

        const float base_up = state->stance[0] / fabsf(state->floor);
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        const float to_team_45 = -3.3748567f - state->stance[0];
        if (to_team_45 >= best) {
            best = to_team_45;
            next = 5U;
        }

        const float base_down = 0.0f - state->floor;
        if (base_down >= best) {
            best = base_down;
            next = 6U;
        }

        const float to_team_13 = state->stance[1] / 0.0f;
        if (to_team_13 >= best) {
            next = 7U;
        }

        if (next == 1U) {
            return WIDOWX_RS_ELBOW_UP;
        }
        if (next == 2U) {
            goto team_32;
        }
        if (next == 3U) {
            goto team_12;
        }
        if (next == 4U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 5U) {
            goto team_45;
        }
        if (next == 6U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        goto team_13;
    }

team_11:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float elbow_up = state->stance[1] / 11.184899f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 1U;
        }

        const float to_team_13 = state->stance[1] / 0.0f;
        if (to_team_13 >= best) {
            best = to_team_13;
            next = 2U;
        }

        const float wrist_up = 164.8815f * state->stance[3];
        if (wrist_up >= best) {
            best = wrist_up;
            next = 3U;
        }

        if (24.873356f >= best) {
            best = 24.873356f;
            next = 4U;
        }

        const float base_down = -3.3748567f - state->stance[0];
        if (base_down >= best) {
            best = base_down;
            next = 5U;
        }

        if (state->stance[3] >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_RS_ELBOW_UP;
        }
        if (next == 2U) {
            goto team_13;
        }
        if (next == 3U) {
            return WIDOWX_RS_WRIST_UP;
        }
        if (next == 5U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 6U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
    }

team_12:
    {
        float best = -FLT_MAX;
        uint32_t next = 8U;
        const float wrist_up = 164.8815f * state->stance[3];
        if (wrist_up >= best) {
            best = wrist_up;
            next = 1U;
        }

        const float to_team_16 = state->stance[1] / 0.0f;
        if (to_team_16 >= best) {
            best = to_team_16;
            next = 2U;
        }

        const float base_up = state->stance[1] / fabsf(state->floor);
        if (base_up >= best) {
            best = base_up;
            next = 3U;
        }

        const float to_team_45 = -3.3748567f - state->stance[0];
        if (to_team_45 >= best) {
            best = to_team_45;
            next = 4U;
        }

        const float shoulder_down = widowx_rs_negate_if_less(state->stance[1], -26.200392f);
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 5U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 6U;
        }

        if (11.302588f >= best) {
            best = 11.302588f;
            next = 7U;
        }

        const float base_down = 0.0f - state->floor;
        if (base_down >= best) {
            next = 8U;
        }

        if (next == 1U) {
            return WIDOWX_RS_WRIST_UP;
        }
        if (next == 2U) {
            goto team_16;
        }
        if (next == 3U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 4U) {
            goto team_45;
        }
        if (next == 5U) {
            return WIDOWX_RS_SHOULDER_DOWN;
        }
        if (next == 6U) {
            goto team_44;
        }
        if (next == 7U) {
            goto team_43;
        }
        return WIDOWX_RS_BASE_DOWN;
    }

team_13:
    {
        float best = 22.918602f;
        uint32_t next = 1U;
        const float to_team_32 = fabsf(state->stance[3]);
        if (to_team_32 >= best) {
            best = to_team_32;
            next = 2U;
        }

        const float wrist_up = 164.8815f * state->stance[3];
        if (wrist_up >= best) {
            best = wrist_up;
            next = 3U;
        }

        const float to_team_14 = state->stance[1] + 9.539528f;
        if (to_team_14 >= best) {
            best = to_team_14;
            next = 4U;
        }

        const float to_team_22 = state->stance[0] / 11.077008f;
        if (to_team_22 >= best) {
            best = to_team_22;
            next = 5U;
        }

        const float to_team_23 = state->stance[0] / 0.0f;
        if (to_team_23 >= best) {
            best = to_team_23;
            next = 6U;
        }

        const float to_team_35 = state->stance[0] / fabsf(state->floor);
        if (to_team_35 >= best) {
            best = to_team_35;
            next = 7U;
        }

        const float to_team_45 = -3.3748567f - state->stance[0];
        if (to_team_45 >= best) {
            best = to_team_45;
            next = 8U;
        }

        const float base_down = widowx_rs_min(to_team_45, state->floor);
        if (base_down >= best) {
            next = 9U;
        }

        if (next == 1U) {
            goto team_41;
        }
        if (next == 2U) {
            goto team_32;
        }
        if (next == 3U) {
            return WIDOWX_RS_WRIST_UP;
        }
        if (next == 4U) {
            goto team_14;
        }
        if (next == 6U) {
            goto team_23;
        }
        if (next == 7U) {
            goto team_35;
        }
        if (next == 8U) {
            goto team_45;
        }
        if (next == 9U) {
            return WIDOWX_RS_BASE_DOWN;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 8U;
        const float base_down_2 = -3.3748567f - state->stance[0];
        const float base_down = widowx_rs_min(base_down_2, state->floor);
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float to_team_30 = fabsf(state->stance[2]);
        if (to_team_30 >= best) {
            best = to_team_30;
            next = 1U;
        }

        const float to_team_32 = state->floor * state->floor;
        if (to_team_32 >= best) {
            best = to_team_32;
            next = 2U;
        }

        if (base_down_2 >= best) {
            best = base_down_2;
            next = 3U;
        }

        const float shoulder_down = -72.49379f * (state->floor / 0.0f);
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 4U;
        }

        if (22.918602f >= best) {
            best = 22.918602f;
            next = 7U;
        }

        const float to_team_23 = state->stance[0] / 0.0f;
        if (to_team_23 >= best) {
            best = to_team_23;
            next = 5U;
        }

        const float wrist_up = 164.8815f * state->stance[3];
        if (wrist_up >= best) {
            best = wrist_up;
            next = 6U;
        }

        const float wrist_down_2 = (state->stance[0] + state->floor) / 9.539528f;
        if (wrist_down_2 >= best) {
            best = wrist_down_2;
            next = 7U;
        }

        const float elbow_down = state->stance[1] - state->floor;
        if (elbow_down >= best) {
            next = 8U;
        }

        if (next == 1U) {
            goto team_30;
        }
        if (next == 2U) {
            goto team_32;
        }
        if (next == 3U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 4U) {
            return WIDOWX_RS_SHOULDER_DOWN;
        }
        if (next == 5U) {
            goto team_23;
        }
        if (next == 6U) {
            return WIDOWX_RS_WRIST_UP;
        }
        if (next == 7U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        return WIDOWX_RS_ELBOW_DOWN;
    }

team_14:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float elbow_up = state->stance[1] / 11.184899f;
        if (elbow_up >= best) {
            best = elbow_up;
            next = 1U;
        }

        if (11.302588f >= best) {
            best = 11.302588f;
            next = 2U;
        }

        const float base_down = 0.0f - state->floor;
        if (base_down >= best) {
            best = base_down;
            next = 3U;
        }

        const float base_down_2 = -3.5602038f - state->stance[0];
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 3U;
        }

        const float base_down_3 = state->stance[1] * state->floor;
        if (base_down_3 >= best) {
            best = base_down_3;
            next = 3U;
        }

        const float base_down_4 = -3.3748567f - state->stance[0];
        if (base_down_4 >= best) {
            best = base_down_4;
            next = 3U;
        }

        const float wrist_up = 164.8815f * state->stance[3];
        if (wrist_up >= best) {
            best = wrist_up;
            next = 4U;
        }

        const float to_team_16 = state->stance[1] / 0.0f;
        if (to_team_16 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            return WIDOWX_RS_ELBOW_UP;
        }
        if (next == 2U) {
            goto team_43;
        }
        if (next == 3U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 4U) {
            return WIDOWX_RS_WRIST_UP;
        }
    }

team_16:
    {
        float best = -FLT_MAX;
        uint32_t next = 8U;
        const float to_team_42 = fabsf(state->floor);
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 1U;
        }

        const float shoulder_down = -72.49379f * (state->floor / 0.0f);
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 2U;
        }

        const float elbow_down = state->stance[1] - state->floor;
        if (elbow_down >= best) {
            best = elbow_down;
            next = 3U;
        }

        if (22.918602f >= best) {
            best = 22.918602f;
            next = 4U;
        }

        const float to_team_32 = state->stance[1] * state->floor;
        if (to_team_32 >= best) {
            best = to_team_32;
            next = 5U;
        }

        const float to_team_30 = fabsf(state->stance[2]);
        if (to_team_30 >= best) {
            best = to_team_30;
            next = 6U;
        }

        const float wrist_up = 164.8815f * state->stance[3];
        if (wrist_up >= best) {
            best = wrist_up;
            next = 7U;
        }

        const float to_team_17 = state->stance[0] / 0.0f;
        if (to_team_17 >= best) {
            next = 8U;
        }

        if (next == 1U) {
            goto team_42;
        }
        if (next == 2U) {
            return WIDOWX_RS_SHOULDER_DOWN;
        }
        if (next == 3U) {
            return WIDOWX_RS_ELBOW_DOWN;
        }
        if (next == 4U) {
            goto team_41;
        }
        if (next == 5U) {
            goto team_32;
        }
        if (next == 6U) {
            goto team_30;
        }
        if (next == 7U) {
            return WIDOWX_RS_WRIST_UP;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 7U;
        const float to_team_35 = fabsf(state->stance[2]);
        if (to_team_35 >= best) {
            best = to_team_35;
            next = 1U;
        }

        const float elbow_down = state->stance[1] / 9.539528f;
        if (elbow_down >= best) {
            best = elbow_down;
            next = 2U;
        }

        const float base_down = widowx_rs_min(-3.3748567f - state->stance[0], state->floor);
        if (base_down >= best) {
            best = base_down;
            next = 6U;
        }

        if (22.918602f >= best) {
            best = 22.918602f;
            next = 3U;
        }

        const float to_team_23 = state->stance[0] / 0.0f;
        if (to_team_23 >= best) {
            best = to_team_23;
            next = 4U;
        }

        const float to_team_18 = state->floor * state->floor;
        if (to_team_18 >= best) {
            best = to_team_18;
            next = 5U;
        }

        const float base_down_2 = widowx_rs_min(state->stance[2], state->stance[3]);
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 6U;
        }

        const float to_team_44 = state->stance[1] / -9.539528f;
        if (to_team_44 >= best) {
            next = 7U;
        }

        if (next == 1U) {
            goto team_35;
        }
        if (next == 2U) {
            return WIDOWX_RS_ELBOW_DOWN;
        }
        if (next == 3U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        if (next == 4U) {
            goto team_23;
        }
        if (next == 6U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 7U) {
            goto team_44;
        }
    }

    {
        float best = 22.918602f;
        uint32_t next = 1U;
        const float shoulder_down = state->stance[1] / 9.539528f;
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 2U;
        }

        const float base_down_3 = -3.3748567f - state->stance[0];
        const float base_down = widowx_rs_min(base_down_3, state->floor);
        if (base_down >= best) {
            best = base_down;
            next = 8U;
        }

        const float to_team_23 = state->stance[0] / 0.0f;
        if (to_team_23 >= best) {
            best = to_team_23;
            next = 3U;
        }

        const float to_team_32 = state->floor * state->floor;
        if (to_team_32 >= best) {
            best = to_team_32;
            next = 4U;
        }

        const float base_down_2 = widowx_rs_min(state->stance[2], state->stance[3]);
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 8U;
        }

        const float to_team_44 = state->stance[1] / -9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 5U;
        }

        const float to_team_33 = state->stance[0] / fabsf(state->floor);
        if (to_team_33 >= best) {
            best = to_team_33;
            next = 6U;
        }

        const float to_team_30 = fabsf(state->stance[2]);
        if (to_team_30 >= best) {
            best = to_team_30;
            next = 7U;
        }

        if (base_down_3 >= best) {
            next = 8U;
        }

        if (next == 1U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        if (next == 2U) {
            return WIDOWX_RS_SHOULDER_DOWN;
        }
        if (next == 3U) {
            goto team_23;
        }
        if (next == 4U) {
            goto team_32;
        }
        if (next == 5U) {
            goto team_44;
        }
        if (next == 6U) {
            goto team_33;
        }
        if (next == 8U) {
            return WIDOWX_RS_BASE_DOWN;
        }
    }

team_30:
    {
        float best = -FLT_MAX;
        uint32_t next = 9U;
        const float base_up = state->stance[0] / fabsf(state->floor);
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        const float wrist_down = (state->stance[0] + state->floor) / 9.539528f;
        if (wrist_down >= best) {
            best = wrist_down;
            next = 1U;
        }

        const float to_team_37 = state->stance[1] / state->floor;
        if (to_team_37 >= best) {
            best = to_team_37;
            next = 2U;
        }

        const float to_team_38 = state->stance[2] - 99.64715f;
        if (to_team_38 >= best) {
            best = to_team_38;
            next = 3U;
        }

        const float base_up_2 = state->stance[0] / 0.0f;
        if (base_up_2 >= best) {
            best = base_up_2;
            next = 4U;
        }

        const float to_team_33 = fabsf(state->stance[2]);
        if (to_team_33 >= best) {
            best = to_team_33;
            next = 5U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 6U;
        }

        const float to_team_45 = -3.3748567f - state->stance[0];
        if (to_team_45 >= best) {
            best = to_team_45;
            next = 7U;
        }

        const float to_team_31 = -72.49379f * (state->floor / 0.0f);
        if (to_team_31 >= best) {
            best = to_team_31;
            next = 8U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            next = 9U;
        }

        if (next == 1U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        if (next == 2U) {
            goto team_37;
        }
        if (next == 3U) {
            goto team_38;
        }
        if (next == 4U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 5U) {
            goto team_33;
        }
        if (next == 6U) {
            return WIDOWX_RS_ELBOW_DOWN;
        }
        if (next == 7U) {
            goto team_45;
        }
        if (next == 9U) {
            goto team_44;
        }
    }

    {
        float best = 7.3802834f;
        uint32_t next = 1U;
        const float to_team_38 = fabsf(state->stance[2]);
        if (to_team_38 >= best) {
            best = to_team_38;
            next = 2U;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            next = 3U;
        }

        const float to_team_34 = state->stance[1] + 9.539528f;
        if (to_team_34 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return WIDOWX_RS_ELBOW_DOWN;
        }
        if (next == 2U) {
            goto team_38;
        }
        if (next == 3U) {
            return WIDOWX_RS_BASE_UP;
        }
        goto team_34;
    }

team_32:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float to_team_38 = -3.3748567f - state->stance[0];
        if (to_team_38 >= best) {
            best = to_team_38;
            next = 1U;
        }

        if (22.918602f >= best) {
            best = 22.918602f;
            next = 2U;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            next = 3U;
        }

        const float to_team_33 = fabsf(state->stance[2]);
        if (to_team_33 >= best) {
            best = to_team_33;
            next = 4U;
        }

        const float to_team_44 = state->stance[1] + 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 6U;
        }

        const float wrist_up = state->stance[3] / 15.430052f;
        if (wrist_up >= best) {
            best = wrist_up;
            next = 5U;
        }

        const float to_team_44_2 = state->stance[1] / 9.539528f;
        if (to_team_44_2 >= best) {
            next = 6U;
        }

        if (next == 1U) {
            goto team_38;
        }
        if (next == 2U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        if (next == 3U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 4U) {
            goto team_33;
        }
        if (next == 5U) {
            return WIDOWX_RS_WRIST_UP;
        }
        goto team_44;
    }

team_23:
    {
        float best = -FLT_MAX;
        uint32_t next = 7U;
        const float to_team_37 = state->stance[1] / 6.928064f;
        if (to_team_37 >= best) {
            best = to_team_37;
            next = 1U;
        }

        const float shoulder_down = state->stance[3] / 15.430052f;
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 2U;
        }

        const float base_up = state->stance[0] / fabsf(state->floor);
        if (base_up >= best) {
            best = base_up;
            next = 3U;
        }

        const float to_team_24 = fabsf(state->stance[2]);
        if (to_team_24 >= best) {
            best = to_team_24;
            next = 4U;
        }

        if (22.918602f >= best) {
            best = 22.918602f;
            next = 5U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 6U;
        }

        const float elbow_up = widowx_rs_max(-161.71835f, state->stance[2]);
        if (elbow_up >= best) {
            next = 7U;
        }

        if (next == 1U) {
            goto team_37;
        }
        if (next == 2U) {
            return WIDOWX_RS_SHOULDER_DOWN;
        }
        if (next == 3U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 5U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        if (next == 6U) {
            goto team_44;
        }
        if (next == 7U) {
            return WIDOWX_RS_ELBOW_UP;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float to_team_38 = -3.3748567f - state->stance[0];
        if (to_team_38 >= best) {
            best = to_team_38;
            next = 1U;
        }

        if (22.918602f >= best) {
            best = 22.918602f;
            next = 2U;
        }

        const float to_team_33 = fabsf(state->stance[2]);
        if (to_team_33 >= best) {
            best = to_team_33;
            next = 3U;
        }

        const float shoulder_down = state->stance[3] / 15.430052f;
        if (shoulder_down >= best) {
            best = shoulder_down;
            next = 4U;
        }

        const float to_team_44 = state->stance[1] + 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 5U;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            next = 6U;
        }

        if (next == 1U) {
            goto team_38;
        }
        if (next == 2U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        if (next == 4U) {
            return WIDOWX_RS_SHOULDER_DOWN;
        }
        if (next == 5U) {
            goto team_44;
        }
        if (next == 6U) {
            return WIDOWX_RS_BASE_UP;
        }
    }

team_33:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float base_up = state->stance[2] / fabsf(state->floor);
        if (base_up >= best) {
            best = base_up;
            next = 1U;
        }

        const float to_team_34 = state->floor + 22.172918f + 9.539528f;
        if (to_team_34 >= best) {
            best = to_team_34;
            next = 2U;
        }

        const float to_team_41 = widowx_rs_max(state->stance[2], 99.64715f);
        if (to_team_41 >= best) {
            best = to_team_41;
            next = 3U;
        }

        const float to_team_45 = -3.3748567f - state->stance[0];
        if (to_team_45 >= best) {
            best = to_team_45;
            next = 4U;
        }

        const float elbow_down = -72.89382f / state->floor;
        if (elbow_down >= best) {
            next = 5U;
        }

        if (next == 1U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 2U) {
            goto team_34;
        }
        if (next == 3U) {
            goto team_41;
        }
        if (next == 5U) {
            return WIDOWX_RS_ELBOW_DOWN;
        }
    }

team_45:
    {
        float best = -FLT_MAX;
        widowx_rs_action_t action = WIDOWX_RS_BASE_DOWN;
        const float shoulder_down = widowx_rs_negate_if_less(state->stance[1], -26.200392f);
        if (shoulder_down >= best) {
            best = shoulder_down;
            action = WIDOWX_RS_SHOULDER_DOWN;
        }

        const float base_down = widowx_rs_max(state->stance[1], state->floor);
        if (base_down >= best) {
            best = base_down;
            action = WIDOWX_RS_BASE_DOWN;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            action = WIDOWX_RS_BASE_UP;
        }

        const float base_down_2 = 0.0f - state->floor;
        if (base_down_2 >= best) {
            best = base_down_2;
            action = WIDOWX_RS_BASE_DOWN;
        }

        const float elbow_down = state->stance[1] / 9.539528f;
        if (elbow_down >= best) {
            best = elbow_down;
            action = WIDOWX_RS_ELBOW_DOWN;
        }

        if (4.372006f >= best) {
            best = 4.372006f;
            action = WIDOWX_RS_BASE_DOWN;
        }

        const float base_down_4 = widowx_rs_min(state->stance[2], state->stance[3]);
        if (base_down_4 >= best) {
            action = WIDOWX_RS_BASE_DOWN;
        }

        return action;
    }

team_41:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float base_down = widowx_rs_max(state->stance[2], state->floor);
        if (base_down >= best) {
            best = base_down;
            next = 2U;
        }

        const float to_team_42 = widowx_rs_max(state->floor, 0.0f);
        if (to_team_42 >= best) {
            best = to_team_42;
            next = 1U;
        }

        const float base_down_2 = -72.49379f * (state->floor / 0.0f);
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 2U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 3U;
        }

        const float base_up = state->stance[0] / fabsf(state->floor);
        if (base_up >= best) {
            best = base_up;
            next = 5U;
        }

        if (10.948133f >= best) {
            best = 10.948133f;
            next = 4U;
        }

        const float base_up_2 = state->stance[0] / 0.0f;
        if (base_up_2 >= best) {
            next = 5U;
        }

        if (next == 2U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 3U) {
            goto team_44;
        }
        if (next == 4U) {
            goto team_43;
        }
        if (next == 5U) {
            return WIDOWX_RS_BASE_UP;
        }
    }

team_42:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            next = 1U;
        }

        const float base_down = widowx_rs_min(state->stance[2], state->stance[3]);
        if (base_down >= best) {
            best = base_down;
            next = 2U;
        }

        const float base_down_2 = -3.3748567f - state->stance[0];
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 2U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 3U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 4U;
        }

        const float to_team_43 = fabsf(state->stance[2]);
        if (to_team_43 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 2U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 3U) {
            goto team_44;
        }
        if (next == 4U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        goto team_43;
    }

team_34:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float base_up = -4.136917f * state->floor;
        if (base_up >= best) {
            best = base_up;
            next = 3U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 4U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 1U;
        }

        const float base_down_2 = -72.49379f * (state->floor / 0.0f);
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 1U;
        }

        const float to_team_36 = fabsf(state->floor);
        if (to_team_36 >= best) {
            best = to_team_36;
            next = 2U;
        }

        const float base_up_2 = state->stance[0] / 0.0f;
        if (base_up_2 >= best) {
            best = base_up_2;
            next = 3U;
        }

        const float to_team_44_2 = state->stance[1] + 9.539528f;
        if (to_team_44_2 >= best) {
            best = to_team_44_2;
            next = 4U;
        }

        const float to_team_35 = state->stance[0] / to_team_36;
        if (to_team_35 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 2U) {
            goto team_36;
        }
        if (next == 3U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 4U) {
            goto team_44;
        }
    }

team_35:
    {
        float best = -FLT_MAX;
        uint32_t next = 6U;
        const float base_down = widowx_rs_min(-3.3748567f - state->stance[0], state->floor);
        if (base_down >= best) {
            best = base_down;
            next = 1U;
        }

        const float base_down_2 = widowx_rs_negate_if_less(-3.3748567f, state->stance[0]);
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 1U;
        }

        const float to_team_40 = state->stance[2] + state->stance[2];
        if (to_team_40 >= best) {
            best = to_team_40;
            next = 2U;
        }

        const float to_team_39 = fabsf(state->stance[2]);
        if (to_team_39 >= best) {
            best = to_team_39;
            next = 3U;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 5U;
        }

        if (0.0f >= best) {
            next = 6U;
        }

        if (next == 1U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 2U) {
            goto team_40;
        }
        if (next == 3U) {
            goto team_39;
        }
        if (next == 4U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 5U) {
            goto team_44;
        }
        return WIDOWX_RS_ELBOW_DOWN;
    }

team_36:
    {
        float best = -FLT_MAX;
        widowx_rs_action_t action = WIDOWX_RS_BASE_DOWN;
        const float elbow_down = state->stance[1] / 9.539528f;
        if (elbow_down >= best) {
            best = elbow_down;
            action = WIDOWX_RS_ELBOW_DOWN;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            action = WIDOWX_RS_SHOULDER_DOWN;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            action = WIDOWX_RS_BASE_UP;
        }

        const float base_down = widowx_rs_min(state->stance[2], state->stance[3]);
        if (base_down >= best) {
            action = WIDOWX_RS_BASE_DOWN;
        }

        return action;
    }

team_38:
    {
        float best = -FLT_MAX;
        uint32_t next = 7U;
        const float to_team_40 = state->stance[2] + state->stance[2];
        if (to_team_40 >= best) {
            best = to_team_40;
            next = 1U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 7U;
        }

        const float to_team_39 = fabsf(state->stance[3]);
        if (to_team_39 >= best) {
            best = to_team_39;
            next = 2U;
        }

        const float wrist_down = widowx_rs_min(state->stance[2], 213.59233f);
        if (wrist_down >= best) {
            best = wrist_down;
            next = 3U;
        }

        const float base_up = state->stance[1] / fabsf(state->floor);
        if (base_up >= best) {
            best = base_up;
            next = 4U;
        }

        if (4.372006f >= best) {
            best = 4.372006f;
            next = 5U;
        }

        const float base_down_2 = -3.3748567f - state->stance[0];
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 5U;
        }

        const float to_team_43 = fabsf(state->stance[2]);
        if (to_team_43 >= best) {
            best = to_team_43;
            next = 6U;
        }

        const float to_team_44_2 = state->stance[1] + 9.539528f;
        if (to_team_44_2 >= best) {
            next = 7U;
        }

        if (next == 1U) {
            goto team_40;
        }
        if (next == 3U) {
            return WIDOWX_RS_WRIST_DOWN;
        }
        if (next == 4U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 5U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 6U) {
            goto team_43;
        }
        if (next == 7U) {
            goto team_44;
        }
    }

team_39:
    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float elbow_down = state->stance[1] / 9.539528f;
        if (elbow_down >= best) {
            best = elbow_down;
            next = 1U;
        }

        const float base_down = -3.3748567f - state->stance[0];
        if (base_down >= best) {
            best = base_down;
            next = 2U;
        }

        const float base_up = state->stance[0] / 17.709658f;
        if (base_up >= best) {
            best = base_up;
            next = 5U;
        }

        const float base_down_2 = widowx_rs_min(state->stance[2], state->stance[3]);
        if (base_down_2 >= best) {
            best = base_down_2;
            next = 2U;
        }

        const float shoulder_up = 0.0f * state->stance[2];
        if (shoulder_up >= best) {
            best = shoulder_up;
            next = 3U;
        }

        const float to_team_43 = fabsf(state->stance[2]);
        if (to_team_43 >= best) {
            best = to_team_43;
            next = 4U;
        }

        const float base_up_2 = state->stance[0] / fabsf(state->floor);
        if (base_up_2 >= best) {
            next = 5U;
        }

        if (next == 1U) {
            return WIDOWX_RS_ELBOW_DOWN;
        }
        if (next == 2U) {
            return WIDOWX_RS_BASE_DOWN;
        }
        if (next == 3U) {
            return WIDOWX_RS_SHOULDER_UP;
        }
        if (next == 5U) {
            return WIDOWX_RS_BASE_UP;
        }
    }

team_43:
    {
        float best = -FLT_MAX;
        widowx_rs_action_t action = WIDOWX_RS_SHOULDER_DOWN;
        const float elbow_down = state->stance[1] / 9.539528f;
        if (elbow_down >= best) {
            best = elbow_down;
            action = WIDOWX_RS_ELBOW_DOWN;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            action = WIDOWX_RS_BASE_UP;
        }

        const float base_down = widowx_rs_min(state->stance[2], state->stance[3]);
        if (base_down >= best) {
            best = base_down;
            action = WIDOWX_RS_BASE_DOWN;
        }

        const float shoulder_down = widowx_rs_max(state->stance[0], 0.0f);
        if (shoulder_down >= best) {
            action = WIDOWX_RS_SHOULDER_DOWN;
        }

        return action;
    }

team_40:
    {
        float best = -FLT_MAX;
        widowx_rs_action_t action = WIDOWX_RS_SHOULDER_DOWN;
        const float elbow_down = state->stance[1] / 9.539528f;
        if (elbow_down >= best) {
            best = elbow_down;
            action = WIDOWX_RS_ELBOW_DOWN;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            action = WIDOWX_RS_BASE_UP;
        }

        const float base_down = -3.3748567f - state->stance[0];
        if (base_down >= best) {
            best = base_down;
            action = WIDOWX_RS_BASE_DOWN;
        }

        const float base_down_2 = fabsf(state->stance[0]);
        if (base_down_2 >= best) {
            best = base_down_2;
            action = WIDOWX_RS_BASE_DOWN;
        }

        const float base_down_3 = widowx_rs_min(state->stance[2], state->stance[3]);
        if (base_down_3 >= best) {
            best = base_down_3;
            action = WIDOWX_RS_BASE_DOWN;
        }

        if (0.0f >= best) {
            action = WIDOWX_RS_SHOULDER_DOWN;
        }

        return action;
    }

team_37:
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            next = 1U;
        }

        const float to_team_44 = state->stance[1] / 9.539528f;
        if (to_team_44 >= best) {
            best = to_team_44;
            next = 2U;
        }

        if (4.372006f >= best) {
            best = 4.372006f;
            next = 3U;
        }

        const float base_down_2 = -3.3748567f - state->stance[0];
        if (base_down_2 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return WIDOWX_RS_BASE_UP;
        }
        if (next == 3U) {
            return WIDOWX_RS_BASE_DOWN;
        }
    }

team_44:
    {
        float best = -FLT_MAX;
        widowx_rs_action_t action = WIDOWX_RS_SHOULDER_UP;
        const float base_down = -3.3748567f - state->stance[0];
        if (base_down >= best) {
            best = base_down;
            action = WIDOWX_RS_BASE_DOWN;
        }

        const float base_up = state->stance[0] / 0.0f;
        if (base_up >= best) {
            best = base_up;
            action = WIDOWX_RS_BASE_UP;
        }

        if (state->floor >= best) {
            best = state->floor;
            action = WIDOWX_RS_SHOULDER_UP;
        }

        if (9.506875f >= best) {
            action = WIDOWX_RS_SHOULDER_UP;
        }

        return action;
    }
}

#ifndef WIDOWX_RS_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t widowx_rs_arithmetic(void)
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

uint32_t widowx_rs_selftest(void)
{
    static const widowx_rs_state_t states[24] = {
        { { -798.6424f, -2578.1226f, 593.26575f, -1148.5238f }, 171.9165f },
        { { 1724.8977f, -239.07426f, -2134.1018f, 1533.6041f }, 428.2142f },
        { { -137.12389f, 474.37292f, -2460.9207f, -966.0493f }, 274.7966f },
        { { -1799.9268f, 3016.9028f, 2533.5088f, 1829.6047f }, 80.74581f },
        { { -27.709257f, -1371.4382f, -2363.3804f, -891.78455f }, 232.65234f },
        { { 2770.1958f, 791.25854f, 781.719f, 874.266f }, 135.45453f },
        { { 2770.1958f, 791.2586f, 781.71893f, 874.2659f }, 135.45453f },
        { { 1e-45f, 2297.0288f, 158.40417f, 1059.7322f }, 202.84442f },
        { { 0.0f, 2297.0288f, 158.40417f, 1059.7322f }, 202.84442f },
        { { -3513.4033f, 1017.0205f, 1877.0833f, 11.3844385f }, 465.25122f },
        { { -3513.4033f, 1017.0205f, 1877.0833f, 11.384438f }, 465.25122f },
        { { -1407.2656f, 1233.272f, -1975.935f, 11.98397f }, 120.22174f },
        { { -1407.2656f, 1233.272f, -1975.935f, 11.983971f }, 120.22174f },
        { { -1306.8396f, 534.8196f, -2316.1567f, 14.047401f }, 183.25998f },
        { { -1306.8396f, 534.8196f, -2316.1567f, 14.0474f }, 183.25998f },
        { { -3579.0815f, 344.3875f, -1317.6948f, 7.9917684f }, 453.00287f },
        { { -3579.0815f, 344.3875f, -1317.6948f, 7.991769f }, 453.00287f },
        { { -945.9846f, 1171.2344f, -1861.9207f, 11.292478f }, 325.847f },
        { { -945.9846f, 1171.2344f, -1861.9207f, 11.292477f }, 325.847f },
        { { 3470.6924f, -1779.6653f, 1558.7356f, -1708.751f }, 139.53455f },
        { { 3470.6924f, -1779.6653f, 1558.7356f, -1708.751f }, 139.53456f },
        { { -241.50284f, 189.03079f, 1856.5781f, 11.260075f }, 378.23035f },
        { { -241.50284f, 189.03079f, 1856.5781f, 11.260076f }, 378.23035f },
        { { 1734.0598f, 1148.0017f, 1138.4622f, 1429.7783f }, 201.20264f },
    };
    static const widowx_rs_action_t actions[24] = {
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_BASE_UP,
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_WRIST_UP,
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_ELBOW_UP,
        WIDOWX_RS_BASE_UP,
        WIDOWX_RS_BASE_UP,
        WIDOWX_RS_WRIST_UP,
        WIDOWX_RS_WRIST_UP,
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_WRIST_UP,
        WIDOWX_RS_WRIST_UP,
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_WRIST_UP,
        WIDOWX_RS_WRIST_UP,
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_BASE_UP,
        WIDOWX_RS_SHOULDER_DOWN,
        WIDOWX_RS_BASE_DOWN,
        WIDOWX_RS_WRIST_UP,
        WIDOWX_RS_ELBOW_UP,
    };
    uint32_t failures = widowx_rs_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (widowx_rs_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
