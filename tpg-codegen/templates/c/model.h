/*
{%- for line in banner %}
 * {{ line }}
{%- endfor %}
 */
#ifndef {{ upper }}_H
#define {{ upper }}_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Words of the model, and of the scratch memory that a decision needs. */
#define {{ upper }}_WORDS {{ words }}U
#define {{ upper }}_SCRATCH {{ scratch }}U

/* For tpg_sac_init of tpg_runtime.h, which checks and borrows it. */
extern const uint32_t {{ prefix }}[{{ upper }}_WORDS];

#ifdef __cplusplus
}
#endif

#endif
