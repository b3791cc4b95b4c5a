//! Output by semihosting, and SysTick as a counter of instructions (see `firmware-c/qemu.c`).

use crate::report::Report;
use cortex_m::peripheral::{SYST, syst::SystClkSource};
use cortex_m_semihosting::{debug, hio};

/// Counts instructions: 25.6 ticks each with `-icount shift=10` on mps2-an386.
pub struct Counter {
    timer: SYST,
    overhead: u32,
}

impl Counter {
    /// Starts the timer.
    pub fn new(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(0x00ff_ffff);
        timer.clear_current();
        timer.enable_counter();
        let mut counter = Self { timer, overhead: 0 };
        let (_, overhead) = counter.measure(|| ());
        counter.overhead = overhead;
        counter
    }

    /// Returns the result of `work`, and the instructions that it took.
    #[inline(always)]
    pub fn measure<T>(&mut self, work: impl FnOnce() -> T) -> (T, u32) {
        self.timer.clear_current();
        let before = SYST::get_current();
        let result = core::hint::black_box(work());
        let after = SYST::get_current();
        let ticks = before.wrapping_sub(after) & 0x00ff_ffff;
        (result, ((ticks * 5 + 64) / 128).saturating_sub(self.overhead))
    }
}

/// Prints.
pub fn print(text: &str) {
    if let Ok(mut stream) = hio::hstdout() {
        let _ = stream.write_all(text.as_bytes());
    }
}

/// Ends QEMU.
pub fn exit(good: bool) -> ! {
    loop {
        debug::exit(if good { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    }
}

/// A program: its work, then the stack that it took, and the end. `None` from the work is a failure.
#[inline(always)]
pub fn run(work: impl FnOnce(&mut Counter) -> Option<()>) -> ! {
    let stack = paint_stack();
    let done = cortex_m::Peripherals::take().and_then(|peripherals| work(&mut Counter::new(peripherals.SYST)));
    if done.is_some() {
        Report::new("done").unsigned("stack", stack_used(stack)).print();
    }
    exit(done.is_some())
}

unsafe extern "C" {
    static _stack_start: u32;
}

const PAINT: u32 = 0xc5c5_c5c5;
/// Depth to which the stack is painted below its top, bytes.
const PAINTED: usize = 8192;

fn top() -> usize {
    &raw const _stack_start as usize
}

/// Paints the stack below the caller's frame; where that ends.
#[inline(always)]
pub fn paint_stack() -> usize {
    let here = cortex_m::register::msp::read() as usize;
    let mut at = top() - PAINTED;
    while at < here {
        // SAFETY: between the end of the painted area and the stack pointer lies nothing that is in use.
        unsafe { (at as *mut u32).write_volatile(PAINT) };
        at += 4;
    }
    here
}

/// Bytes of stack below an address that were written to since.
pub fn stack_used(below: usize) -> u32 {
    let mut at = top() - PAINTED;
    // SAFETY: stack memory, from which any number may be read.
    while at < below && unsafe { (at as *const u32).read_volatile() } == PAINT {
        at += 4;
    }
    (below - at) as u32
}

/// Nothing here panics: the linker leaves this out, and `cargo xtask qemu` looks for it.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    exit(false)
}
