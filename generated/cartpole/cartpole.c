/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix cartpole --profile fast
 * Graph SHA-256: b5cd35e439ef2cb063083c5c6d233008b3172426fbda1ff61d89268cd8839ef5
 * 1 teams (1 on the longest walk), 2 edges, 2 programs, 2 distinct operations.
 * Computes in f32 with own maths.
 */
#include "cartpole.h"

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

/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */

uint16_t cartpole_infer(const cartpole_state_t *state)
{
    uint32_t vertex;

    {
        float best = -FLT_MAX;
        uint32_t way = 2U;
        const float v5 = state->v[0] / (-3.2907495F);

        if (v5 >= best) {
            best = v5;
            way = 1U;
        }
        const float v2 = state->theta[0] + state->omega[0];

        if (v2 >= best) {
            way = 2U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else {
            vertex = 1U;
            goto decided;
        }
    }

decided:
    return (uint16_t)vertex;
}

#ifndef CARTPOLE_NO_SELFTEST

uint32_t cartpole_selftest(void)
{
    static const cartpole_state_t states[16] = {
        { { -0.9361377F }, { -0.44416824F }, { 0.08089407F }, { -0.29353777F } },
        { { -2.0765705F }, { 0.23748176F }, { -0.032598697F }, { -0.36226624F } },
        { { 3.5978985F }, { 0.23317035F }, { -0.014026452F }, { 0.075386174F } },
        { { -3.8451886F }, { -0.24565889F }, { -0.03898949F }, { -0.23075496F } },
        { { 4.713911F }, { 0.45568788F }, { 0.37457627F }, { -0.3822737F } },
        { { -1.5006326F }, { -0.0116182575F }, { -0.08600891F }, { -0.50550765F } },
        { { -4.3303714F }, { -0.33087566F }, { 0.021383751F }, { -0.24322434F } },
        { { -3.951202F }, { -0.4224597F }, { 0.41135326F }, { 0.1968056F } },
        { { -3.7608438F }, { 0.095859624F }, { 0.19331068F }, { 0.20675866F } },
        { { -2.6551597F }, { 0.49979717F }, { -0.3114527F }, { 0.13240597F } },
        { { 2.917333F }, { 0.09766981F }, { 0.33477452F }, { -0.12862018F } },
        { { -0.22236307F }, { 0.46632433F }, { -0.13526149F }, { 0.12549497F } },
        { { -2.095407F }, { -0.2857737F }, { 0.06020357F }, { 0.4456905F } },
        { { -1.4888382F }, { 0.4502451F }, { 0.41569287F }, { 0.39719024F } },
        { { 2.2312365F }, { 0.026156906F }, { 0.12560135F }, { 0.06652385F } },
        { { 1.0976024F }, { -0.020576168F }, { 0.124302566F }, { 0.105662875F } },
    };
    static const uint16_t actions[16] = {
        0U, 0U, 1U, 0U, 1U, 0U, 0U, 1U, 1U, 0U, 1U, 1U, 1U, 1U, 1U, 1U
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (cartpole_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
