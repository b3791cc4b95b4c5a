{% include "rust/tables.rs" %}
{% if !constants.is_empty() %}
/// What programs read besides the state.
const CONSTANTS: [{{ scalar }}; {{ constants.len() }}] = {{ layout::array(constants, 0) }};
{% endif %}
/// A value that is known already.
fn operand(frame: &[{{ scalar }}; {{ bytecode.frame }}], place: {{ wide }}) -> {{ scalar }} {
    let place = (place & {{ operand_mask }}) as usize;
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
