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

#define {{ upper }}_INPUTS {{ policy.inputs.len() }}U
#define {{ upper }}_OUTPUTS {{ policy.output.described().len() }}U

/* The observation:
{%- for input in policy.inputs %}
 * {{ loop.index0 }} {{ input }}
{%- endfor %}
 */
typedef struct {
    float values[{{ upper }}_INPUTS];
} {{ prefix }}_state_t;

/* The {% if policy.is_choice() %}actions{% else %}outputs{% endif %}:
{%- for output in policy.output.described() %}
 * {{ loop.index0 }} {{ output }}
{%- endfor %}
 */
{% if policy.is_choice() -%}
uint16_t {{ prefix }}_infer(const {{ prefix }}_state_t *state);
{% else -%}
typedef struct {
    float values[{{ upper }}_OUTPUTS];
} {{ prefix }}_action_t;

void {{ prefix }}_infer(const {{ prefix }}_state_t *state, {{ prefix }}_action_t *action);
{% endif %}
#ifdef __cplusplus
}
#endif

#endif
