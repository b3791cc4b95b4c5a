        // The state, the constants, and the results of a program, one after another.
        let mut frame = [{{ zero }}; {{ frame }}];
{%- if constants %}
        let known = s.iter().chain(&CONSTANTS);
{%- else %}
        let known = s.iter();
{%- endif %}
        for (place, &value) in frame.iter_mut().zip(known) {
            *place = value;
        }
        let mut vertex = 0;
        for _ in 0..Self::DEPTH {
            let edges = span(&TEAMS, vertex);
            let bidders = BIDDERS.get(edges.clone()).unwrap_or(&[]);
            let targets = TARGETS.get(edges).unwrap_or(&[]);
            let Some(&last) = targets.last() else {
                break;
            };
            // Only bids above minus infinity win; where there is none, the last edge does.
            let mut best = {{ scalar }}::MIN;
            let mut winner = last;
            for (&bidder, &target) in bidders.iter().zip(targets) {
                let bid = run(&mut frame, bidder as usize);
                if bid >= best {
                    best = bid;
                    winner = target;
                }
            }
            vertex = winner as usize;
        }
{%- if outputs.is_empty() %}
        ActionId(vertex.wrapping_sub({{ teams }}) as u16)
{%- else %}
        let first = vertex.wrapping_sub({{ teams }}).wrapping_mul({{ outputs.len() }});
{%- for output in outputs %}
        let program = LEAVES.get(first.wrapping_add({{ output.place }}));
        let {{ output.variable }} = program.map_or({{ zero }}, |&program| run(&mut frame, program as usize));
{%- endfor %}
        {{ limited }}
{%- endif %}
