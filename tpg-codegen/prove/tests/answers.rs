//! The three answers, for C that a person could have written.

use tpg_prove::c;
use tpg_prove::graph::Graph;
use tpg_prove::product::Effort;
use tpg_prove::proof::{Proof, Verdict, prove, sampled};

/// Left is bid `x - y`, right is bid 0.5, stay is bid `|y|`.
const GRAPH: &str = r#"{ "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 2,
  "sources": [{ "name": "x", "length": 1, "unit": "m", "ranges": [[-1, 1]] }, { "name": "y", "length": 2, "unit": "m", "ranges": [[-1, 1]] }],
  "instructions": ["sub", "copy", "abs", "exp"],
  "actions": [{ "id": 0, "name": "left" }, { "id": 1, "name": "right" }, { "id": 2, "name": "stay" }],
  "root": 7,
  "teams": [{ "id": 7, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }, { "program": 2, "action": 2 }] }],
  "programs": [
    { "id": 0, "lines": [{ "to": 0, "op": "sub", "args": ["x[0]", "y[1]"] }] },
    { "id": 1, "lines": [{ "to": 0, "op": "copy", "args": [0.5] }] },
    { "id": 2, "lines": [{ "to": 0, "op": "abs", "args": ["y[1]"] }] } ] }"#;

const HEAD: &str = "#include <stdint.h>
#include <math.h>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize(\"fp-contract=off\") /* GCC fuses in GNU modes */
#else
#pragma STDC FP_CONTRACT OFF
#endif
typedef struct state { float x; float y[2]; } state_t;
enum action { LEFT, RIGHT, STAY };
";

fn proof_of(graph: &str, body: &str) -> Proof {
    let graph = Graph::read("graph.json", graph).expect("a graph");
    let text = format!("{HEAD}{body}");
    let read = || c::read_with("policy.c", &text, &|_| None, None, graph.interface());
    let proof = prove(&graph, &read, false, Effort::default(), None);
    // whatever is proven never differs in a state that is computed by itself
    if matches!(proof.verdict, Verdict::Proven) {
        assert_eq!(sampled(&graph, &read, 500, 3), None, "{body}");
    }
    proof
}

const GOOD: &str = "uint16_t pole_infer(const state_t *s)
{
    const float stay = fabsf(s->y[1]);
    float best = s->x - s->y[1];
    uint32_t way = LEFT;
    if (!(best > 0.5f)) { best = 0.5f; way = RIGHT; }
    if (stay >= best) way = STAY;
    return (uint16_t)way;
}";

#[test]
fn another_way_to_find_the_winner_is_proven() {
    let proof = proof_of(GRAPH, GOOD);
    assert!(matches!(proof.verdict, Verdict::Proven), "{proof}");
    let nested = "static float larger(float a, float b) { return a > b ? a : b; }
        enum action pole_infer(const state_t *s)
        {
            switch ((fabsf(s->y[1]) >= larger(s->x - s->y[1], 0.5f)) ? 1 : 0) {
            case 1: return STAY;
            default: break;
            }
            for (int i = 0; i < 3; i++) { switch (i) { case 0: continue; default: break; } if (i == 2) goto end; }
        end:
            return s->x - s->y[1] > 0.5f ? LEFT : RIGHT;
        }";
    let proof = proof_of(GRAPH, nested);
    assert!(matches!(proof.verdict, Verdict::Proven), "{proof}");
    let bits = "#include <string.h>
        uint16_t pole_infer(const state_t *s)
        {
            union { float f; uint32_t u; } difference;
            uint32_t magnitude;
            (void)memcpy(&magnitude, &s->y[1], sizeof magnitude);
            difference.f = s->x - s->y[1];
            /* numbers as large as 0.5, by their bits; no NaN */
            magnitude &= 0x7fffffffU;
            const float best = (difference.u > 0x3f000000U && difference.u <= 0x7f800000U) ? difference.f : 0.5f;
            float stay;
            (void)memcpy(&stay, &magnitude, sizeof stay);
            return stay >= best ? STAY : difference.f > 0.5f ? LEFT : RIGHT;
        }";
    let proof = proof_of(GRAPH, bits);
    assert!(!matches!(proof.verdict, Verdict::Different(_)), "{proof}");
}

#[test]
fn a_difference_has_a_state() {
    for (from, to) in [
        ("best > 0.5f", "best >= 0.5f"),
        ("0.5f; way", "0.25f; way"),
        ("s->x - s->y[1]", "s->x - s->y[0]"),
        (">= best", "> best"),
    ] {
        let proof = proof_of(GRAPH, &GOOD.replace(from, to));
        let Verdict::Different(difference) = &proof.verdict else {
            // a tie of these bids is a state that is rarely met
            assert!(matches!(proof.verdict, Verdict::Undecided(_)) && to.contains("best"), "{from}: {proof}");
            continue;
        };
        assert_eq!(difference.state.len(), 3);
        assert_ne!(difference.expected, difference.found);
    }
}

#[test]
fn what_is_missing_is_named() {
    let none = |body: &str, what: &str| {
        let proof = proof_of(GRAPH, body);
        assert!(
            matches!(&proof.verdict, Verdict::Undecided(missing) if missing.to_string().contains(what)),
            "{body}\n{proof}"
        );
    };
    none(
        "uint16_t pole_infer(const state_t *s) { float best; return best > s->x ? LEFT : STAY; }",
        "not set on every way",
    );
    none("uint16_t pole_infer(const state_t *s) { return s->y[2] > 0.0f ? LEFT : STAY; }", "in bounds");
    none("uint16_t pole_infer(const state_t *s) { return s->x > 0.0 ? LEFT : STAY; }", "binary64");
    none("uint16_t pole_infer(const state_t *s) { return cbrtf(s->x) > 0.0f ? LEFT : STAY; }", "`cbrtf`");
    none("uint16_t pole_infer(const state_t *s) { return pole_infer(s); }", "calls itself");
    none("uint16_t pole_infer(const state_t *s) { return (uint16_t)(uint32_t)s->x; }", "range of an integer");
    none(
        "uint16_t pole_infer(const state_t *s) { int k = 2147483647; return k + 1 < 0 ? LEFT : STAY; }",
        "holds the result",
    );
    for variable in ["static int left = 0;", "int left = 0;", "static const volatile int left = 0;"] {
        let body = format!("{variable}\nuint16_t pole_infer(const state_t *s) {{ return left ? LEFT : STAY; }}");
        none(&body, "other static variables may change");
    }
    none("uint16_t pole_infer(const state_t *s) { ((state_t *)s)->x = 1.0f; return STAY; }", "does not change");
    for condition in ["ifdef __arm__", "ifndef NDEBUG", "if defined(__GNUC__)", "if 0\n#elif defined(__AVR__)"] {
        let body = GOOD.replace("    if (!(best", &format!("#{condition}\n    best = 0.5f;\n#endif\n    if (!(best"));
        none(&body, "depends on this text alone");
    }
    let opaque = |mask: &str| {
        format!(
            "static uint32_t opaque(uint32_t mask)\n{{\n#if defined(__GNUC__) && !defined(__FRAMAC__)\n\
             uint32_t hidden = {mask};\n\n__asm__(\"\" : \"+r\"(hidden));\nreturn hidden;\n#else\nreturn mask;\n#endif\n}}\n{GOOD}"
        )
    };
    assert!(matches!(proof_of(GRAPH, &opaque("mask")).verdict, Verdict::Proven));
    none(&opaque("~mask"), "depends on this text alone");
    for pragma in ["STDC FP_CONTRACT ON", "GCC optimize(\"fast-math\")", "pack(1)"] {
        none(&format!("#pragma {pragma}\n{GOOD}"), "#pragma");
    }
    let text = format!("{}{GOOD}", HEAD.replace("#pragma GCC optimize(\"fp-contract=off\")", ""));
    let graph = Graph::read("graph.json", GRAPH).expect("a graph");
    let error = c::read_with("policy.c", &text, &|_| None, None, graph.interface()).expect_err("GCC fuses");
    assert!(error.to_string().contains("against fused operations"), "{error}");
    none("#include \"absent.h\"\nuint16_t pole_infer(const state_t *s) { return 0; }", "absent.h");
}

/// One output: `floor((3 * x - 5 * y) / 4)`, limited to -100 to 100, and 0 where `x * y` bids more than 7.
const COUNTS: &str = r#"{ "format": "tpg-graph", "version": 2, "scalar": "f64", "maths": "own", "registers": 2,
  "sources": [{ "name": "x", "length": 1, "unit": "m", "ranges": [[-9, 9]], "counts": [{ "bits": 16, "scale": 0.5 }] },
    { "name": "y", "length": 1, "unit": "m", "ranges": [[-9, 9]], "counts": [{ "bits": 7, "scale": 0.5 }] }],
  "instructions": ["mul", "sub", "copy", "quotient"],
  "outputs": [{ "name": "u", "unit": "", "min": -100, "max": 100, "nan": 0, "counts": { "bits": 8, "scale": 1 } }],
  "root": 0,
  "teams": [{ "id": 0, "edges": [{ "program": 0, "leaf": 0 }, { "program": 1, "leaf": 1 }] }],
  "leaves": [{ "id": 0, "programs": [2] }, { "id": 1, "programs": [3] }],
  "programs": [
    { "id": 0, "lines": [{ "to": 0, "op": "copy", "args": [8] }] },
    { "id": 1, "lines": [{ "to": 0, "op": "mul", "args": ["x[0]", "y[0]"] }] },
    { "id": 2, "lines": [{ "to": 0, "op": "mul", "args": ["x[0]", 3] }, { "to": 1, "op": "mul", "args": ["y[0]", 5] },
      { "to": 0, "op": "sub", "args": ["r0", "r1"] }, { "to": 0, "op": "quotient", "args": ["r0", 4] }] },
    { "id": 3, "lines": [] } ] }"#;

const COUNTED: &str = "#include <stdint.h>
#define TWICE(number) (2 * (number))
typedef struct state { int16_t x; int8_t y; } state_t;
typedef struct answer { int8_t u; } answer_t;
static const int16_t weights[2] = { 3, -5 };
void pole_infer(const state_t *s, answer_t *answer)
{
    int32_t sum = 0;
    if ((int32_t)s->x * s->y - 1 > 6) { answer->u = 0; return; }
    sum += TWICE((int32_t)s->x) + s->x;
    sum += (int32_t)s->y * weights[1];
    sum = sum < 0 ? -1 - ((-1 - sum) >> 2) : sum >> 2;
    answer->u = (int8_t)(sum >= 100 ? 100 : sum < -100 ? -100 : sum);
}";

#[test]
fn counts_are_whole_numbers_that_never_overflow() {
    let graph = Graph::read("graph.json", COUNTS).expect("a graph of counts");
    let proof_of = |text: &str| {
        prove(
            &graph,
            &|| c::read_with("policy.c", text, &|_| None, None, graph.interface()),
            false,
            Effort::default(),
            None,
        )
    };
    let proof = proof_of(COUNTED);
    assert!(matches!(proof.verdict, Verdict::Proven) && proof.in_range == Some(true), "{proof}");
    assert!(proof.to_string().contains("every answer is a number in its range"), "{proof}");
    let different = proof_of(&COUNTED.replacen("- 1 > 6", "- 1 > 7", 1)).to_string();
    assert!(different.starts_with("different") && !different.contains("in its range"), "{different}");
    for (from, to) in [
        ("- 1 > 6", "- 1 > 7"),
        ("3, -5", "3, -4"),
        ("2 * (number)", "3 * (number)"),
        (">= 100", ">= 99"),
        ("? -1 - (", "? - ("),
        (" - 1 > 6", " > 6"),
        ("u = 0;", "u = -1;"),
    ] {
        let proof = proof_of(&COUNTED.replacen(from, to, 1));
        assert!(
            matches!(&proof.verdict, Verdict::Different(difference) if difference.state.len() == 2),
            "{to}: {proof}"
        );
    }
    for (from, to, what) in [
        // what C does not define, or leaves to the compiler, and what a type does not hold
        ("((-1 - sum) >> 2)", "((sum) >> 2)", "policy.c:12: a number that its integer type holds"),
        ("int32_t sum = 0", "int32_t sum = 2147483647 + 1", "policy.c:8: a number that its integer type holds"),
        ("sum += TWICE", "sum += 2147483647 + TWICE", "policy.c:10: a number that its integer type holds"),
        ("sum < -100 ? -100", "sum < -200 ? -100", "policy.c:13: a number that its integer type holds"),
        (
            "sum += TWICE((int32_t)s->x)",
            "sum += 7 / s->x + TWICE((int32_t)s->x)",
            "policy.c:10: a divisor that is never 0",
        ),
        ("int16_t x", "int32_t x", "a structure of the numbers"),
        ("sum < 0 ?", "(uint32_t)sum > 7U ?", "a number that its integer type holds"),
    ] {
        let proof = proof_of(&COUNTED.replacen(from, to, 1));
        assert!(
            matches!(&proof.verdict, Verdict::Undecided(missing) if missing.to_string().contains(what)),
            "{to}: {proof}"
        );
    }
    for (from, to, place) in [
        ("\"args\": [8]", "\"args\": [8.5]", "graph.programs[0].lines[0].args[0]"),
        (r#", "counts": { "bits": 8, "scale": 1 }"#, "", "graph.outputs[0].counts"),
        (r#""bits": 16"#, r#""bits": 17"#, "graph.sources[0].counts[0].bits"),
    ] {
        let error = Graph::read("graph.json", &COUNTS.replacen(from, to, 1)).expect_err(place);
        assert_eq!(error.place, format!("graph.json: {place}"), "{error}");
    }
}

#[test]
fn own_maths_is_compared_as_it_is_written() {
    let graph = GRAPH.replace(r#""op": "abs""#, r#""op": "exp""#);
    let maths = include_str!("../src/own_maths.c");
    let body = GOOD.replace("fabsf", "own_exp");
    let proof = proof_of(&graph, &format!("{maths}\n{body}"));
    assert!(matches!(proof.verdict, Verdict::Proven), "{proof}");
    let other = maths.replace("0.008368675f", "0.008368674f");
    assert_ne!(maths, other);
    let proof = proof_of(&graph, &format!("{other}\n{body}"));
    assert!(!matches!(proof.verdict, Verdict::Proven), "{proof}");
}

#[test]
fn code_may_skip_functions_that_cannot_matter() {
    let body = |word: &str, unless: &str| {
        GOOD.replace("    const float stay = fabsf(s->y[1]);\n", "").replace(
            "if (stay >= best) way = STAY;",
            &format!("if (!({unless})) {{ if (own_{word}(s->y[1]) >= best) way = STAY; }}"),
        )
    };
    let maths = include_str!("../src/own_maths.c");
    for (word, skipped, too_often) in [
        ("cos", "best > 1.0f", "best > 0.9f"),
        ("sin", "best > 1.0f", "best >= 1.0f"),
        ("exp", "s->y[1] <= 2.0f && best >= 7.5f", "s->y[1] <= 2.0f && best >= 7.0f"),
        ("ln", "s->y[1] <= 8000.0f && best >= 9.0f", "best >= 9.0f"),
    ] {
        let graph = GRAPH.replace(r#""abs""#, &format!("\"{word}\""));
        for (unless, is_proven) in [(skipped, true), (too_often, false)] {
            let proof = proof_of(&graph, &format!("{maths}\n{}", body(word, unless)));
            assert_eq!(matches!(proof.verdict, Verdict::Proven), is_proven, "{word}, {unless}: {proof}");
        }
    }
}

#[test]
fn bad_graphs_are_refused_with_their_place() {
    for (from, to, place) in [
        (r#""root": 7"#, r#""root": 8"#, "graph.root"),
        (r#""f32""#, r#""f64""#, "graph.scalar"),
        (r#""action": 2"#, r#""team": 7"#, "graph.teams"),
        (r#""action": 1"#, r#""action": 3"#, "graph.teams[0].edges[1].action"),
        ("y[1]", "y[2]", "graph.programs[0].lines[0].args[1]"),
        (r#""unit": "m","#, r#""unit": "m", "counts": [],"#, "graph.scalar"),
        (r#""version": 1"#, r#""version": 3"#, "graph.version"),
        (r#""root": 7"#, r#""root": -7"#, "graph.root"),
        (r#""id": 2, "lines""#, r#""id": 1, "lines""#, "graph.programs[2].id"),
        (r#""program": 1"#, r#""program": 9"#, "graph.teams[0].edges[1].program"),
        (r#""action": 1"#, r#""action": 1, "team": 7"#, "graph.teams[0].edges[1]"),
        ("0.5]", "1e39]", "graph.programs[1].lines[0].args[0]"),
        (r#""to": 0"#, r#""to": 2"#, "graph.programs[0].lines[0].to"),
        (r#"["y[1]"] }] } ] }"#, r#"["y[1]"] }] } ] } }"#, "the end"),
    ] {
        let error = Graph::read("graph.json", &GRAPH.replacen(from, to, 1)).expect_err(place);
        assert_eq!(error.place, format!("graph.json: {place}"), "{error}");
    }
}
