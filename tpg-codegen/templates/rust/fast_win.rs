{%- if leads -%}
lead.take{% if !bid.ascending %}_at{% endif %}({{ bid.value }}, {{ bid.rank }});
{%- else -%}
if {{ bid.wins }} {
best = {{ bid.value }};
{{ team.winner }} = {{ bid.rank }};
}
{%- endif -%}
