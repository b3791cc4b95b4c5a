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

{% if let Some(general) = general -%}
/* For tpg_network_init of tpg_runtime.h, which checks and borrows it, and {{ general.ask }}. Inputs:
{%- for input in general.inputs %}
 * {{ input }}
{%- endfor %}
 * Outputs:
{%- for output in general.outputs %}
 * {{ output }}
{%- endfor %}
 */
#define {{ upper }}_INPUTS {{ general.inputs.len() }}U
#define {{ upper }}_OUTPUTS {{ general.outputs.len() }}U
{% else -%}
/* For tpg_sac_init of tpg_runtime.h, which checks and borrows it. */
{% endif -%}
extern const uint32_t {{ prefix }}[{{ upper }}_WORDS];

#ifdef __cplusplus
}
#endif

#endif
