//! The error bounds that `ops::own` states, measured, and its special values.

use std::f64::consts::PI;
use std::process::{Command, Stdio};

use tpg_runtime::ops::own;

type Function = fn(f64) -> f64;
type Function32 = fn(f32) -> f32;

/// Sine and cosine are off by at most 1.5 ulp each, and the quotient is rounded.
const TAN_ULPS: f64 = 3.5;

/// A prime, so that the stride meets every exponent and all kinds of mantissas: 4.3 million of the 2³² arguments.
/// With 1 it takes minutes and gives the figures that the module states.
const STRIDE: usize = 997;

/// `|got − reference|` in units in the last place of an `f32` near the reference.
fn ulps_f32(got: f32, reference: f64) -> f64 {
    let magnitude = reference.abs().max(f64::from(f32::MIN_POSITIVE));
    let exponent = (magnitude.to_bits() >> 52) as i32 - 1023;
    (f64::from(got) - reference).abs() / 2_f64.powi(exponent - 23)
}

/// The greatest absolute error and the greatest one in ulp, over a stride through all bit patterns.
fn worst_f32(kernel: fn(f32) -> f32, reference: fn(f64) -> f64) -> (f64, f64) {
    let mut worst = (0_f64, 0_f64);
    for bits in (0..=u32::MAX).step_by(STRIDE) {
        let x = f32::from_bits(bits);
        let (got, expected) = (kernel(x), reference(f64::from(x)));
        let rounded = expected as f32;
        if rounded.is_finite() {
            assert!(got.is_finite(), "{x:e}: {got} instead of {expected:e}");
            worst.0 = worst.0.max((f64::from(got) - expected).abs());
            worst.1 = worst.1.max(ulps_f32(got, expected));
        } else {
            assert!(got == rounded || (got.is_nan() && rounded.is_nan()), "{x:e}: {got} instead of {rounded}");
        }
    }
    worst
}

#[test]
fn f32_circle_is_within_its_bounds() {
    for (kernel, reference) in
        [(own::f32::sin as fn(f32) -> f32, f64::sin as fn(f64) -> f64), (own::f32::cos, f64::cos)]
    {
        let (absolute, ulps) = worst_f32(kernel, reference);
        assert!(absolute <= 8.8e-8 && ulps <= 1.5, "{absolute:e}, {ulps} ulp");
    }
}

#[test]
fn f32_tan_is_within_its_bound() {
    let (_, ulps) = worst_f32(own::f32::tan, f64::tan);
    assert!(ulps <= TAN_ULPS, "{ulps} ulp");
}

#[test]
fn f32_ln_is_within_its_bound() {
    let (_, ulps) = worst_f32(own::f32::ln, f64::ln);
    assert!(ulps <= 0.96, "{ulps} ulp");
}

#[test]
fn f32_exp_is_within_its_bound() {
    let (_, ulps) = worst_f32(own::f32::exp, f64::exp);
    assert!(ulps <= 1.0, "{ulps} ulp");
}

#[test]
fn f32_atan_and_tanh_are_within_their_bounds() {
    for (kernel, reference, bound) in
        [(own::f32::atan as fn(f32) -> f32, f64::atan as fn(f64) -> f64, 2.1), (own::f32::tanh, f64::tanh, 1.5)]
    {
        let (_, ulps) = worst_f32(kernel, reference);
        assert!(ulps <= bound, "{ulps} ulp");
    }
}

#[test]
fn f64_is_within_its_bounds_at_the_hard_points() {
    let hexadecimal = |text: &str| u64::from_str_radix(text, 16).unwrap();
    let mut counts = [0; 4];
    for line in include_str!("fixtures/own_maths/reference.txt").lines().filter(|line| !line.starts_with('#')) {
        let fields: Vec<&str> = line.split(' ').collect();
        let [name, x, nearest, rest] = fields[..] else { panic!("{line}") };
        let (x, nearest) = (f64::from_bits(hexadecimal(x)), hexadecimal(nearest));
        let rest = rest.parse::<f64>().unwrap() * 1e-6;
        let (index, kernel, bound): (usize, fn(f64) -> f64, f64) = match name {
            "sin" => (0, own::f64::sin, 1.5),
            "cos" => (1, own::f64::cos, 1.5),
            "ln" => (2, own::f64::ln, 0.96),
            "exp" => (3, own::f64::exp, 1.0),
            _ => panic!("{line}"),
        };
        // Neighbouring doubles have neighbouring bits.
        let steps = kernel(x).to_bits().wrapping_sub(nearest) as i64;
        let ulps = (steps as f64 - rest).abs();
        assert!(ulps <= bound, "{name} {x:e}: {ulps} ulp");
        if index < 2 {
            let place = 2_f64.powi(((nearest >> 52) & 0x7ff).max(1) as i32 - 1075);
            assert!(ulps * place <= 1.7e-16, "{name} {x:e}: {:e}", ulps * place);
        }
        counts[index] += 1;
    }
    assert!(counts.iter().all(|&count| count > 250), "{counts:?}");
}

/// Random bits (xorshift): the same ones in every run.
fn random_bits() -> impl Iterator<Item = u64> {
    std::iter::successors(Some(0x9e37_79b9_7f4a_7c15_u64), |&state| {
        let state = state ^ (state << 13);
        let state = state ^ (state >> 7);
        Some(state ^ (state << 17))
    })
}

/// Doubles of all exponents, of moderate ones and evenly spread ones.
fn random_doubles() -> impl Iterator<Item = f64> {
    random_bits().enumerate().map(|(index, bits)| match index % 3 {
        0 => f64::from_bits(bits),
        1 => f64::from_bits((bits & 0x800f_ffff_ffff_ffff) | ((1015 + ((bits >> 52) & 15)) << 52)),
        _ => (bits as i64) as f64 / 2_f64.powi(53),
    })
}

#[test]
fn f64_is_near_the_platforms_functions() {
    // They are correct to an ulp or so themselves.
    let pairs: [(Function, Function, u64); 7] = [
        (own::f64::sin, f64::sin, 3),
        (own::f64::cos, f64::cos, 3),
        (own::f64::ln, f64::ln, 3),
        (own::f64::exp, f64::exp, 3),
        (own::f64::tan, f64::tan, 5),
        (own::f64::atan, f64::atan, 3),
        (own::f64::tanh, f64::tanh, 3),
    ];
    for x in random_doubles().take(500_000) {
        for (index, (kernel, reference, ulps)) in pairs.into_iter().enumerate() {
            let (got, expected) = (kernel(x), reference(x));
            let close = (got.to_bits().wrapping_sub(expected.to_bits()) as i64).unsigned_abs() <= ulps;
            assert!(close || (got.is_nan() && expected.is_nan()), "{index} of {x:e}: {got:e}, {expected:e}");
        }
    }
}

#[test]
fn special_values() {
    macro_rules! check {
        ($module:ident, $float:ident) => {{
            use own::$module::{atan, cos, exp, ln, sin, tan, tanh};
            const INFINITY: $float = $float::INFINITY;
            for x in [INFINITY, -INFINITY, $float::NAN, -$float::NAN] {
                assert!(sin(x).is_nan() && cos(x).is_nan() && tan(x).is_nan(), "{x}");
            }
            for x in [$float::NAN, -$float::NAN] {
                assert!(exp(x).is_nan() && atan(x).is_nan() && tanh(x).is_nan());
            }
            for x in [0.0, $float::from_bits(1)] {
                assert_eq!([atan(x), tanh(x)].map($float::to_bits), [x.to_bits(); 2]);
            }
            let half: $float = std::f64::consts::FRAC_PI_2 as $float;
            assert_eq!((atan(INFINITY), atan($float::MAX), tanh(INFINITY), tanh($float::MAX)), (half, half, 1.0, 1.0));
            for x in [-INFINITY, -1.0, -$float::MIN_POSITIVE, -$float::from_bits(1), $float::NAN, -$float::NAN] {
                assert!(ln(x).is_nan(), "{x}");
            }
            assert_eq!(sin(0.0).to_bits(), (0.0 as $float).to_bits());
            assert_eq!(sin(-0.0).to_bits(), (-0.0 as $float).to_bits());
            assert_eq!(sin($float::from_bits(1)).to_bits(), 1);
            assert_eq!([tan(0.0), tan(-0.0)].map($float::to_bits), [0.0, -0.0 as $float].map($float::to_bits));
            assert_eq!(tan($float::from_bits(1)).to_bits(), 1);
            assert_eq!((cos(0.0), cos(-0.0), cos($float::MIN_POSITIVE)), (1.0, 1.0, 1.0));
            assert_eq!((ln(0.0), ln(-0.0), ln(INFINITY)), (-INFINITY, -INFINITY, INFINITY));
            assert_eq!(ln(1.0).to_bits(), 0);
            assert_eq!((exp(0.0), exp(-0.0), exp($float::MIN_POSITIVE)), (1.0, 1.0, 1.0));
            assert_eq!((exp(INFINITY), exp($float::MAX)), (INFINITY, INFINITY));
            assert_eq!((exp(-INFINITY).to_bits(), exp($float::MIN).to_bits()), (0, 0));
        }};
    }
    check!(f32, f32);
    check!(f64, f64);

    // The ends of the ranges: the last finite result, the first infinite one, the last subnormal one, the first zero.
    assert!(own::f32::exp(88.722_84) == f32::INFINITY && own::f32::exp(88.72283) < f32::MAX);
    assert_eq!((own::f32::exp(-103.97207).to_bits(), own::f32::exp(-103.97209).to_bits()), (1, 0));
    assert!(own::f64::exp(709.782712893385) == f64::INFINITY && own::f64::exp(709.782712893383) < f64::MAX);
    assert_eq!((own::f64::exp(-745.1332191019411).to_bits(), own::f64::exp(-745.1332191019413).to_bits()), (1, 0));
}

#[test]
fn sine_is_odd_cosine_even_and_both_are_bounded() {
    for x in random_doubles().filter(|x| x.is_finite()).take(500_000) {
        assert_eq!(own::f64::sin(-x).to_bits(), (-own::f64::sin(x)).to_bits());
        assert_eq!(own::f64::cos(-x).to_bits(), own::f64::cos(x).to_bits());
        assert_eq!(own::f64::atan(-x).to_bits(), (-own::f64::atan(x)).to_bits());
        assert_eq!(own::f64::tanh(-x).to_bits(), (-own::f64::tanh(x)).to_bits());
        assert!(own::f64::tanh(x).abs() <= 1.0);
        assert!(own::f64::sin(x).abs() <= 1.0 && own::f64::cos(x).abs() <= 1.0);
    }
    for x in random_bits().map(|bits| f32::from_bits(bits as u32)).filter(|x| x.is_finite()).take(500_000) {
        assert_eq!(own::f32::sin(-x).to_bits(), (-own::f32::sin(x)).to_bits());
        assert_eq!(own::f32::tan(-x).to_bits(), (-own::f32::tan(x)).to_bits());
        assert_eq!(own::f32::cos(-x).to_bits(), own::f32::cos(x).to_bits());
        assert_eq!(own::f32::atan(-x).to_bits(), (-own::f32::atan(x)).to_bits());
        assert_eq!(own::f32::tanh(-x).to_bits(), (-own::f32::tanh(x)).to_bits());
        assert!(own::f32::tanh(x).abs() <= 1.0);
        assert!(own::f32::sin(x).abs() <= 1.0 && own::f32::cos(x).abs() <= 1.0);
    }
    // Where the quadrants meet, rounding must not carry a result past ±1.
    for quarter in 1..2000 {
        let near = (f64::from(quarter) * PI / 2.0) as f32;
        for bits in near.to_bits() - 50..near.to_bits() + 50 {
            let x = f32::from_bits(bits);
            assert!(own::f32::sin(x).abs() <= 1.0 && own::f32::cos(x).abs() <= 1.0, "{x:e}");
        }
    }
}

/// A prime stride through all 2³² numbers; each core takes its share. With `TPG_EVERY_NUMBER=1` every one of them: four CPU minutes.
#[test]
fn f32_results_lie_in_their_ranges() {
    let stride: usize = match std::env::var("TPG_EVERY_NUMBER") {
        Ok(every) if every == "1" => 1,
        _ => tpg_testing::amount(127, 7),
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for first in (0..threads).map(|thread| (thread * stride) as u32) {
            scope.spawn(move || (first..=u32::MAX).step_by(threads * stride).for_each(check_ranges));
        }
    });
}

/// Asserts the ranges of all functions of the number with these bits.
fn check_ranges(bits: u32) {
    let x = f32::from_bits(bits);
    let [sin, cos, ln, exp] = [own::f32::sin, own::f32::cos, own::f32::ln, own::f32::exp].map(|kernel| kernel(x));
    let circle = |y: f32| if x.is_finite() { y.abs() <= 1.0 } else { y.is_nan() };
    assert!(circle(sin) && circle(cos), "{x:e}: {sin} {cos}");
    assert!(if x.is_nan() { exp.is_nan() } else { exp >= 0.0 }, "{x:e}: {exp}");
    let in_range = (-103.98..=88.73).contains(&ln) || (x == 0.0 && ln == f32::NEG_INFINITY);
    assert!(if x >= 0.0 { in_range || x == f32::INFINITY } else { ln.is_nan() || x == 0.0 }, "{x:e}: {ln}");
}

#[test]
fn f32_ln_and_exp_rise() {
    // Steps of 64 bit patterns are wider than the errors: a fall would be a seam between two pieces.
    let mut before = f32::NEG_INFINITY;
    for bits in (0..f32::INFINITY.to_bits()).step_by(64) {
        let after = own::f32::ln(f32::from_bits(bits));
        assert!(after >= before, "ln {:e}", f32::from_bits(bits));
        before = after;
    }
    let mut before = 0.0;
    for bits in (0..105_f32.to_bits()).step_by(64) {
        let after = own::f32::exp(-f32::from_bits(105_f32.to_bits() - bits));
        assert!(after >= before, "exp {:e}", -f32::from_bits(105_f32.to_bits() - bits));
        before = after;
    }
}

/// The functions of one number that the prover defines.
const PROVEN: [(&str, Function32); 7] = [
    ("sin", own::f32::sin),
    ("cos", own::f32::cos),
    ("tan", own::f32::tan),
    ("ln", own::f32::ln),
    ("exp", own::f32::exp),
    ("atan", own::f32::atan),
    ("tanh", own::f32::tanh),
];

/// Prints a hash of the results of every 2^24 numbers.
const HASHES: &str = "#include <stdio.h>
int main(void)
{
    uint32_t hash = 0U;
    uint32_t number = 0U;
    do {
        const float y = FUNCTION(own_float(number));
        hash = (hash ^ ((y != y) ? 0x7fc00000U : own_bits(y))) * 16777619U;
        number++;
        if ((number & 0xffffffU) == 0U) {
            printf(\"%lu\\n\", (unsigned long)hash);
        }
    } while (number != 0U);
    return 0;
}
";

/// What the prover takes for granted about a result.
fn granted(name: &str, x: f32, y: f32) -> bool {
    let bounded = match name {
        "sin" | "cos" | "tanh" => y.is_nan() || y.abs() <= 1.0,
        "atan" => y.is_nan() || y.abs() <= std::f32::consts::FRAC_PI_2,
        "exp" => y.is_nan() == x.is_nan() && (y.is_nan() || y >= 0.0) && (x > 2.0 || x.is_nan() || y < 7.5),
        "ln" => y.is_nan() || x > 8000.0 || y < 9.0,
        _ => true,
    };
    bounded && (!x.is_nan() || y.is_nan())
}

#[test]
#[ignore = "minutes: cargo xtask lemmas runs it"]
fn the_provers_definition_is_this_for_every_number() {
    if !tpg_testing::tool("gcc", "gcc", "the prover's own maths") {
        return;
    }
    let definition = concat!(env!("CARGO_MANIFEST_DIR"), "/../tpg-codegen/prove/src/own_maths.c");
    let folder = std::env::temp_dir();
    for (name, function) in PROVEN {
        let program = folder.join(format!("own_{name}_{}", std::process::id()));
        let source = program.with_extension("c");
        let text = HASHES.replace("FUNCTION", &format!("own_{name}"));
        std::fs::write(&source, format!("#include \"{definition}\"\n{text}")).expect("a temporary file");
        let mut gcc = Command::new("gcc");
        gcc.args(["-O2", "-ffp-contract=off", "-Wno-unused-function"]).arg(&source).arg("-o").arg(&program);
        assert!(gcc.status().expect("gcc starts").success());
        let child = Command::new(&program).stdout(Stdio::piped()).spawn().expect("it starts");
        let mut hash = 0_u32;
        let hashes: Vec<String> = (0..256_u32)
            .map(|block| {
                for number in 0..1 << 24 {
                    let x = f32::from_bits(block << 24 | number);
                    let y = function(x);
                    assert!(granted(name, x, y), "{name} of {x:e} is {y:e}");
                    hash = (hash ^ if y.is_nan() { 0x7fc0_0000 } else { y.to_bits() }).wrapping_mul(16_777_619);
                }
                hash.to_string()
            })
            .collect();
        let printed = child.wait_with_output().expect("it ends").stdout;
        let printed = String::from_utf8(printed).expect("numbers");
        assert!(printed.lines().eq(&hashes), "{name}");
        for file in [source, program] {
            std::fs::remove_file(file).expect("it was there");
        }
    }
}
