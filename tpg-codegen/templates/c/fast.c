{%- let entry = printer.entry() -%}
{%- let prefix = printer.prefix -%}
{%- let scalar = printer.scalar() -%}
{%- let lowest = printer.lowest() -%}
{%- if teams.len() > 1 %}
/* {{ rule }} No team leads back to one above it. */
{%- else %}
/* {{ rule }} */
{%- endif %}
{{ entry.head }}
{
{%- if !leaves.is_empty() || answers_in_place %}
{%- for output in outputs %}
    {{ scalar }} {{ output.variable }};
{%- endfor %}
{% endif %}
{%- if !reads_state %}

    (void)state;
{%- endif %}
{% for team in teams %}
{%- if self.is_entered("team", team.view.label) %}
team_{{ team.view.label }}:
{%- endif %}
{%- if teams.len() > 1 %}
    {
{%- endif %}
{%- if let Some(first) = team.view.first %}
{%- for statement in first.statements %}
        {{ statement }}
{%- endfor %}
{%- endif %}
{%- if team.keeps_winner %}
{%- if let Some(first) = team.view.first %}
{%- if leads %}
        {{ prefix }}_lead_t lead = { {{ first.value }}, {{ first.rank }} };
{%- else %}
        {{ team.view.kind }} best = {{ first.value }};
        {{ team.winner_type }} {{ team.view.winner }} = {{ first.rank }};
{%- endif %}
{%- else if leads %}
        {{ prefix }}_lead_t lead = { {{ lowest }}, {{ team.view.initial }} };
{%- else %}
        {{ team.view.kind }} best = {{ lowest }};
        {{ team.winner_type }} {{ team.view.winner }} = {{ team.view.initial }};
{%- endif %}
{%- endif %}
{%- for bid in team.view.eager %}
{%- for statement in bid.statements %}
        {{ statement }}
{%- endfor %}
{%- if team.keeps_winner %}{% include "c/fast_win.c" %}
{% endif %}
{%- endfor %}
{%- for bid in team.view.lazy %}
{%- for statement in bid.before %}
        {{ statement }}
{%- endfor %}
{%- if let Some(considered) = bid.considered %}

        if ({{ considered }}) {
{%- endif %}
{%- for statement in bid.bound %}
        {{ statement }}
{%- endfor %}

        {% if let Some(guard) = bid.guard %}if ({{ guard }}) {% endif %}{
{%- for statement in bid.statements %}
            {{ statement }}
{%- endfor %}
{%- include "c/fast_win.c" %}
        }
{%- if bid.considered.is_some() %}
        }
{%- endif %}
{%- endfor %}

{% for line in team.decision %}
{{ line }}
{%- endfor %}
{%- if teams.len() > 1 %}
    }
{%- endif %}
{% endfor %}
{%- for leaf in leaves %}

{%- if self.is_entered("leaf", leaf.label) %}
leaf_{{ leaf.label }}:
{%- endif %}
    {
{%- for statement in leaf.statements %}
        {{ statement }}
{%- endfor %}
{% for value in leaf.values %}
        {{ outputs[loop.index0].variable }} = {{ value }};
{%- endfor %}
    }
{%- if !loop.last %}
    {% if outputs.is_empty() %}return{% else %}goto answered{% endif %};
{% endif %}
{% endfor %}
{%- if leaves.len() > 1 && !outputs.is_empty() %}
answered:
{%- endif %}
{%- if !leaves.is_empty() || answers_in_place %}
{% for assignment in assignments %}
    {{ assignment }}
{%- endfor %}
{%- endif %}
}
