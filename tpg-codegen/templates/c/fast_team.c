
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
{%- for statement in step.before %}
        {{ statement }}
{%- endfor %}
{%- for statement in step.outside %}
        {{ statement }}
{%- endfor %}
{%- if let Some(considered) = step.considered %}

        if ({{ considered }}) {
{%- endif %}
{%- for statement in step.bound %}
        {{ statement }}
{%- endfor %}
{%- if step.continues %}
{%- else if let Some(guard) = step.guard %}

        if ({{ guard }}) {
{%- else if !step.statements.is_empty() %}

        {
{%- endif %}
{%- for statement in step.statements %}
        {{ statement }}
{%- endfor %}
{%- if step.is_late %}

        if (lead.late != 0U) {
            lead.best = {{ prefix }}_bid_{{ team.label }}(state, lead.winner, lead.best);
            lead.late = 0U;
        }
{%- endif %}
        {{ prefix }}_{{ step.take }}(&lead, {{ step.value }}, {{ step.rank }});
{%- if !step.goes_on && (step.guard.is_some() || !step.statements.is_empty()) %}
        }
{%- endif %}
{%- if step.considered.is_some() %}
        }
{%- endif %}
{%- endfor %}
{%- if !team.steps_before.is_empty() %}

        if (lead.best < {{ infinity }}) {
{%- for step in team.steps_before %}
{%- for statement in step.before %}
        {{ statement }}
{%- endfor %}
{%- for statement in step.outside %}
        {{ statement }}
{%- endfor %}
{%- if let Some(considered) = step.considered %}

        if ({{ considered }}) {
{%- endif %}
{%- for statement in step.bound %}
        {{ statement }}
{%- endfor %}
{%- if step.continues %}
{%- else if let Some(guard) = step.guard %}

        if ({{ guard }}) {
{%- else if !step.statements.is_empty() %}

        {
{%- endif %}
{%- for statement in step.statements %}
        {{ statement }}
{%- endfor %}
{%- if step.is_late %}

        if (lead.late != 0U) {
            lead.best = {{ prefix }}_bid_{{ team.label }}(state, lead.winner, lead.best);
            lead.late = 0U;
        }
{%- endif %}
        {{ prefix }}_{{ step.take }}(&lead, {{ step.value }}, {{ step.rank }});
{%- if !step.goes_on && (step.guard.is_some() || !step.statements.is_empty()) %}
        }
{%- endif %}
{%- if step.considered.is_some() %}
        }
{%- endif %}
{%- endfor %}
        }
{%- endif %}
{%- for step in team.steps_lazy %}
{%- for statement in step.before %}
        {{ statement }}
{%- endfor %}
{%- for statement in step.outside %}
        {{ statement }}
{%- endfor %}
{%- if let Some(considered) = step.considered %}

        if ({{ considered }}) {
{%- endif %}
{%- for statement in step.bound %}
        {{ statement }}
{%- endfor %}
{%- if step.continues %}
{%- else if let Some(guard) = step.guard %}

        if ({{ guard }}) {
{%- else if !step.statements.is_empty() %}

        {
{%- endif %}
{%- for statement in step.statements %}
        {{ statement }}
{%- endfor %}
{%- if step.is_late %}

        if (lead.late != 0U) {
            lead.best = {{ prefix }}_bid_{{ team.label }}(state, lead.winner, lead.best);
            lead.late = 0U;
        }
{%- endif %}
        {{ prefix }}_{{ step.take }}(&lead, {{ step.value }}, {{ step.rank }});
{%- if !step.goes_on && (step.guard.is_some() || !step.statements.is_empty()) %}
        }
{%- endif %}
{%- if step.considered.is_some() %}
        }
{%- endif %}
{%- endfor %}
