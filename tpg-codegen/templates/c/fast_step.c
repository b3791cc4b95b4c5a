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
