        let mut vertex = 0;
        for _ in 0..Self::DEPTH {
            vertex = match vertex {
{%- for team in teams %}
                {{ loop.index0 }} => team_{{ team.label }}(s),
{%- endfor %}
                _ => break,
            };
        }
        ActionId(vertex.wrapping_sub({{ teams.len() }}) as u16)
