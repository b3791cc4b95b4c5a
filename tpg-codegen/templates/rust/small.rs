{%- let scalar = printer.scalar() -%}
{%- let zero = printer.literal(0.0) %}

/// Instructions: from the highest bits, an operation and two places.
{%- let name = "CODE" -%}
{%- let values = bytecode.code -%}
{% include "rust/table.rs" %}

/// Where each program begins, and where the last ends.
{%- let name = "PROGRAMS" -%}
{%- let values = bytecode.programs -%}
{% include "rust/table.rs" %}

/// The program of each edge.
{%- let name = "BIDDERS" -%}
{%- let values = bytecode.bidders -%}
{% include "rust/table.rs" %}

/// Where each edge leads: teams from 0, the root; the actions follow.
{%- let name = "TARGETS" -%}
{%- let values = bytecode.targets -%}
{% include "rust/table.rs" %}

/// Where each team's edges begin, and where the last team's end.
{%- let name = "TEAMS" -%}
{%- let values = bytecode.teams -%}
{% include "rust/table.rs" %}
{% if !outputs.is_empty() %}
/// The program of each output of each leaf.
{%- let name = "LEAVES" -%}
{%- let values = bytecode.leaves -%}
{% include "rust/table.rs" %}
{% endif %}
{% include "rust/span.rs" %}

{% if !constants.is_empty() %}
/// What programs read besides the state.
const CONSTANTS: [{{ scalar }}; {{ constants.len() }}] = {{ layout::array(constants, 0) }};
{% endif %}
/// A value that is known already.
fn operand(frame: &[{{ scalar }}; {{ bytecode.frame }}], place: {{ wide }}) -> {{ scalar }} {
    let place = (place & {{ bytecode.operand_mask() }}) as usize;
    frame.get(place).copied().unwrap_or({{ zero }})
}

/// Runs a program: its results follow one another in the frame, and the last is its bid.
fn run(frame: &mut [{{ scalar }}; {{ bytecode.frame }}], program: usize) -> {{ scalar }} {
    let code = CODE.get(span(&PROGRAMS, program)).unwrap_or(&[]);
    let mut result = {{ zero }};
    for (place, &instruction) in code.iter().enumerate() {
        let instruction = instruction as {{ wide }};
        let a = operand(frame, instruction);
        let b = operand(frame, instruction >> {{ bytecode.operand_bits }});
        result = match instruction >> {{ bytecode.operand_bits * 2 }} {
{%- for (number, expression) in cases %}
{%- if loop.last %}
            _ => {{ expression }},
{%- else %}
            {{ number }} => {{ expression }},
{%- endif %}
{%- endfor %}
        };
        if let Some(place) = frame.get_mut({{ bytecode.first_result }} + place) {
            *place = result;
        }
    }
    result
}
