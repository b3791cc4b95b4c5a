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

{% if let Output::Preferences(_) = policy.output -%}
/* For tpg_sac_init of tpg_runtime.h, which checks and borrows it. */
{% else -%}
/* For tpg_network_init of tpg_runtime.h, which checks and borrows it, and {% if policy.is_choice() %}tpg_network_choose{% else %}tpg_network_values{% endif %}. Inputs:
{%- for input in policy.inputs %}
 * {{ loop.index0 }} {{ input }}
{%- endfor %}
 * Outputs:
{%- for output in policy.output.described() %}
 * {{ loop.index0 }} {{ output }}
{%- endfor %}
 */
#define {{ upper }}_INPUTS {{ policy.inputs.len() }}U
#define {{ upper }}_OUTPUTS {{ policy.output.described().len() }}U
{% endif -%}
extern const uint32_t {{ prefix }}[{{ upper }}_WORDS];

#ifdef __cplusplus
}
#endif

#endif
