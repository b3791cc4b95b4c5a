//! Many policies in one program; its argument says which one decides for states from standard input: see tpg-codegen's
//! verify::process.
{% for policy in policies %}
mod {{ policy.prefix }};
{%- endfor %}

use std::io::{self, Read, Write};
use tpg_runtime::policy::{ActionId, Policy};

fn serve<const N: usize, S: Copy + Default, A, B: IntoIterator<Item = u8>, const W: usize>(
    policy: impl Policy<State = [S; N], Action = A>,
    number: fn([u8; W]) -> S,
    bytes_of: fn(A) -> B,
) -> io::Result<()> {
    let mut input = io::stdin().lock();
    let mut output = io::stdout().lock();
    let mut head = [0; 4];
    while input.read_exact(&mut head).is_ok() {
        let count = u32::from_le_bytes(head) as usize;
        let mut bytes = vec![0; count * N * W];
        input.read_exact(&mut bytes)?;
        let mut actions = Vec::with_capacity(count * 2);
        for values in bytes.chunks_exact(N * W) {
            let mut state = [S::default(); N];
            for (slot, value) in state.iter_mut().zip(values.chunks_exact(W)) {
                *slot = number(value.try_into().unwrap());
            }
            actions.extend(bytes_of(policy.decide(&state)));
        }
        output.write_all(&actions)?;
        output.flush()?;
    }
    Ok(())
}

fn main() -> io::Result<()> {
    match std::env::args().nth(1).and_then(|number| number.parse::<usize>().ok()) {
{%- for policy in policies %}
        Some({{ loop.index0 }}) => serve({{ policy.prefix }}::{{ policy.name }}, {{ policy.scalar }}::from_ne_bytes, {% if policy.outputs == 0 %}|ActionId(action)| action.to_ne_bytes(){% else %}|values| values.into_iter().flat_map({{ policy.scalar }}::to_ne_bytes){% endif %}),
{%- endfor %}
        _ => Err(io::Error::other("no such policy")),
    }
}
