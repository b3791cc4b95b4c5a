/*
 * Made by tpg-codegen 0.1.0 from a network in integers; do not edit.
 * Weights' SHA-256: 86b07b4f7e22d70e1aa1f8caa90e6425ebe378bfd20ef6c864f5c9656deaa1b9
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
