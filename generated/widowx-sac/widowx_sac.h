/*
 * Made by tpg-codegen 0.1.0 from a network in integers; do not edit.
 * Weights' SHA-256: e56e4aa8c274247a654e0c90c2868c61c79273012e5756ed8131e3ccc319f277
 * 3 layers, 6784 multiplications a decision, 8012 bytes.
 * Actions: fine; mask: joint-limits.
 */
#ifndef WIDOWX_SAC_H
#define WIDOWX_SAC_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Words of the model, and of the scratch memory that a decision needs. */
#define WIDOWX_SAC_WORDS 2003U
#define WIDOWX_SAC_SCRATCH 64U

/* For tpg_sac_init of tpg_runtime.h, which checks and borrows it. */
extern const uint32_t widowx_sac[WIDOWX_SAC_WORDS];

#ifdef __cplusplus
}
#endif

#endif
