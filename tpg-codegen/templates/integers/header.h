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
{% if outputs.is_empty() %}
/* The actions. */
typedef enum {{ prefix }}_action {
{%- for (constant, name) in actions %}
    {{ constant }} = {{ loop.index0 }}{% if !loop.last %},{% endif %}{% if !name.is_empty() %} /* {{ name }} */{% endif %}
{%- endfor %}
} {{ prefix }}_action_t;
#define {{ upper }}_ACTIONS {{ actions.len() }}U
{%- else %}
#define {{ upper }}_OUTPUTS {{ outputs.len() }}U
{%- endif %}

/* What the policy sees, in counts. Every value that the types hold is legal{% if look.is_some() %}; of an image, every one that {{ prefix }}_look writes{% endif %}. */
typedef struct {{ prefix }}_state {
{%- for source in sources %}
{%- if let [meaning] = source.meaning.as_slice() %}
    {{ source.kind }} {{ source.member() }}; /* {{ meaning }} */
{%- else %}
    /*
{%- for meaning in source.meaning %}
     * [{{ loop.index0 }}] {{ meaning }}
{%- endfor %}
     */
    {{ source.kind }} {{ source.field }}[{{ source.length }}];
{%- endif %}
{%- endfor %}
} {{ prefix }}_state_t;
{% if outputs.is_empty() %}
/* The action for a state. Pure and reentrant: no globals, no memory, no side effect. */
{{ prefix }}_action_t {{ prefix }}_infer(const {{ prefix }}_state_t *state);
{% else %}
/* What the policy answers, in counts, each in its range. */
typedef struct {{ prefix }}_action {
{%- for output in outputs %}
    {{ output.kind }} {{ output.field }}; /* {{ output.meaning[0] }} */
{%- endfor %}
} {{ prefix }}_action_t;
{% if memory.is_empty() %}
/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void {{ prefix }}_infer(const {{ prefix }}_state_t *state, {{ prefix }}_action_t *action);
{% else %}
/* The values that the policy carries from one decision to the next, each in its range. */
typedef struct {{ prefix }}_memory {
{%- for value in memory %}
    {{ value.kind }} {{ value.field }}; /* {{ value.meaning[0] }} */
{%- endfor %}
} {{ prefix }}_memory_t;

/* Sets the memory as it is before the first decision of an episode. */
void {{ prefix }}_reset({{ prefix }}_memory_t *memory);

/* The answer to a state, and the next memory. Reentrant: no globals, no side effect but *memory and *action. */
void {{ prefix }}_infer(const {{ prefix }}_state_t *state, {{ prefix }}_memory_t *memory, {{ prefix }}_action_t *action);
{% endif %}
{%- endif %}
{%- if let Some(look) = look %}
{% include "c/look.h" %}
{% endif %}
#ifndef {{ upper }}_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
{%- if let Some(quality) = quality %}
 * {{ quality }}
 */
{%- else %} */{% endif %}
uint32_t {{ prefix }}_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
