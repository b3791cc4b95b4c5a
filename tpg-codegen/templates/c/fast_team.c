
{%- if let Some(first) = team.first %}
{%- for statement in first.statements %}
        {{ statement }}
{%- endfor %}
        {{ prefix }}_lead_t lead = { {{ first.value }}, {% if near %}0.0, 0U, {% endif %}{{ first.rank }} };
{%- else %}
        {{ prefix }}_lead_t lead = { -{{ lowest }}, {% if near %}0.0, 0U, {% endif %}{{ team.nobody }} };
{%- endif %}
{%- if let Some(infinite) = team.infinite %}
{%- for statement in infinite.statements %}
        {{ statement }}
{%- endfor %}

        if ({{ infinite.condition }}) {
            lead.best = {{ infinity }};
            lead.winner = {{ infinite.rank }};
        }
{%- endif %}
{%- for step in team.steps %}
{%- include "c/fast_step.c" %}
{%- endfor %}
{%- if !team.steps_before.is_empty() %}

        if (lead.best < {{ infinity }}) {
{%- for step in team.steps_before %}
{%- include "c/fast_step.c" %}
{%- endfor %}
        }
{%- endif %}
{%- for step in team.steps_lazy %}
{%- include "c/fast_step.c" %}
{%- endfor %}
