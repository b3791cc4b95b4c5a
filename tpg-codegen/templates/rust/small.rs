{% for (name, doc, table) in tables %}
/// {{ doc }}
const {{ name }}: [{{ table.kind }}; {{ table.values.len() }}] = {{ layout::array(table.values, 0) }};
{% endfor %}
{% if !constants.is_empty() %}
/// What programs read besides the state.
const CONSTANTS: [{{ scalar }}; {{ constants.len() }}] = {{ layout::array(constants, 0) }};
{% endif %}
/// From an entry of a table to the next.
fn span<T: Copy + Into<u32>>(table: &[T], place: usize) -> core::ops::Range<usize> {
    let at = |place: usize| table.get(place).map_or(0, |&entry| entry.into() as usize);
    at(place)..at(place + 1)
}

/// A value that is known already.
fn operand(frame: &[{{ scalar }}; {{ frame }}], place: {{ wide }}) -> {{ scalar }} {
    let place = (place & {{ operand_mask }}) as usize;
    frame.get(place).copied().unwrap_or({{ zero }})
}

/// Runs a program: its results follow one another in the frame, and the last is its bid.
fn run(frame: &mut [{{ scalar }}; {{ frame }}], program: usize) -> {{ scalar }} {
    let code = CODE.get(span(&PROGRAMS, program)).unwrap_or(&[]);
    let mut result = {{ zero }};
    for (place, &instruction) in code.iter().enumerate() {
        let instruction = instruction as {{ wide }};
        let a = operand(frame, instruction);
        let b = operand(frame, instruction >> {{ operand_bits }});
        result = match instruction >> {{ operand_bits * 2 }} {
{%- for (number, expression) in cases %}
{%- if loop.last %}
            _ => {{ expression }},
{%- else %}
            {{ number }} => {{ expression }},
{%- endif %}
{%- endfor %}
        };
        if let Some(place) = frame.get_mut({{ first_result }} + place) {
            *place = result;
        }
    }
    result
}
