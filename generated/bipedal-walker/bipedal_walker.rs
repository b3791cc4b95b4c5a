//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix bipedal_walker --profile constant-time
//! Graph SHA-256: 9d8c42d624c3770a63b707f660b7746c1bc1c049e8b73961774134beff3c0e09
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 190 distinct operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops::constant_time::ConstantTime;
use tpg_runtime::policy::Policy;

/// A tangled program graph: a formula.
///
/// It sees, one after another:
/// - `s[0..24]`: obs, , -3.1415927410125732 to 3.1415927410125732; -5 to 5; -5 to 5; -5 to 5; -3.1415927410125732 to 3.1415927410125732; -5 to 5; -3.1415927410125732 to 3.1415927410125732; -5 to 5; -0 to 5; -3.1415927410125732 to 3.1415927410125732; -5 to 5; -3.1415927410125732 to 3.1415927410125732; -5 to 5; -0 to 5; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: action_0, , -1 to 1; 0 in place of NaN
/// - `[1]`: action_1, , -1 to 1; 0 in place of NaN
/// - `[2]`: action_2, , -1 to 1; 0 in place of NaN
/// - `[3]`: action_3, , -1 to 1; 0 in place of NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct BipedalWalker;

impl BipedalWalker {
    /// Values of a state.
    pub const STATE: usize = 24;
    /// Outputs.
    pub const OUTPUTS: usize = 4;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 0;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 190;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for BipedalWalker {
    type State = [f32; 24];
    type Action = [f32; 4];

    fn decide(&self, s: &[f32; 24]) -> [f32; 4] {
        let ct = ConstantTime::<f32>::default();
        let v2 = s[0] * 0.5046787_f32;
        let v5 = s[1] * 8.018429_f32;
        let v6 = v2 + v5;
        let v9 = s[2] * 1.1309677_f32;
        let v10 = v6 + v9;
        let v13 = s[3] * 1.3572947_f32;
        let v14 = v10 + v13;
        let v17 = s[4] * -1.4042757_f32;
        let v18 = v14 + v17;
        let v21 = s[5] * -0.20148475_f32;
        let v22 = v18 + v21;
        let v25 = s[7] * -0.15425919_f32;
        let v26 = v22 + v25;
        let v29 = s[8] * 0.22009312_f32;
        let v30 = v26 + v29;
        let v33 = s[9] * 0.7223859_f32;
        let v34 = v30 + v33;
        let v37 = s[10] * 0.05046511_f32;
        let v38 = v34 + v37;
        let v41 = s[11] * -0.47640488_f32;
        let v42 = v38 + v41;
        let v45 = s[12] * 0.33258402_f32;
        let v46 = v42 + v45;
        let v49 = s[13] * -0.14858565_f32;
        let v50 = v46 + v49;
        let v53 = s[14] * 0.7674586_f32;
        let v54 = v50 + v53;
        let v57 = s[15] * -0.17519812_f32;
        let v58 = v54 + v57;
        let v61 = s[16] * 1.8191909_f32;
        let v62 = v58 + v61;
        let v65 = s[17] * 1.8449576_f32;
        let v66 = v62 + v65;
        let v69 = s[18] * -2.8432984_f32;
        let v70 = v66 + v69;
        let v73 = s[19] * -0.18586843_f32;
        let v74 = v70 + v73;
        let v77 = s[20] * -0.771481_f32;
        let v78 = v74 + v77;
        let v81 = s[21] * 1.6962188_f32;
        let v82 = v78 + v81;
        let v85 = s[22] * 1.1837615_f32;
        let v86 = v82 + v85;
        let v89 = s[23] * -6.4229074_f32;
        let v90 = v86 + v89;
        let v92 = v90 + 2.5260677_f32;
        let v94 = s[0] * 1.8828421_f32;
        let v96 = s[1] * 8.03671_f32;
        let v97 = v94 + v96;
        let v99 = s[2] * -0.094880946_f32;
        let v100 = v97 + v99;
        let v102 = s[3] * -2.3845007_f32;
        let v103 = v100 + v102;
        let v105 = s[4] * 0.6801684_f32;
        let v106 = v103 + v105;
        let v108 = s[5] * -0.04494099_f32;
        let v109 = v106 + v108;
        let v112 = s[6] * -0.5763401_f32;
        let v113 = v109 + v112;
        let v115 = s[7] * -0.1844264_f32;
        let v116 = v113 + v115;
        let v118 = s[8] * -0.035329953_f32;
        let v119 = v116 + v118;
        let v121 = s[9] * 0.8470248_f32;
        let v122 = v119 + v121;
        let v124 = s[10] * 0.13221936_f32;
        let v125 = v122 + v124;
        let v127 = s[11] * 0.72477835_f32;
        let v128 = v125 + v127;
        let v130 = s[12] * 0.15656033_f32;
        let v131 = v128 + v130;
        let v133 = s[13] * 0.18303227_f32;
        let v134 = v131 + v133;
        let v136 = s[14] * -0.9859452_f32;
        let v137 = v134 + v136;
        let v139 = s[15] * -1.3015733_f32;
        let v140 = v137 + v139;
        let v142 = s[16] * -1.0328742_f32;
        let v143 = v140 + v142;
        let v145 = s[17] * -2.4927297_f32;
        let v146 = v143 + v145;
        let v148 = s[18] * 1.37519_f32;
        let v149 = v146 + v148;
        let v151 = s[19] * -2.2172704_f32;
        let v152 = v149 + v151;
        let v154 = s[20] * 1.180808_f32;
        let v155 = v152 + v154;
        let v157 = s[21] * -1.329915_f32;
        let v158 = v155 + v157;
        let v160 = s[22] * -0.25188348_f32;
        let v161 = v158 + v160;
        let v163 = s[23] * 6.103324_f32;
        let v164 = v161 + v163;
        let v166 = v164 + -2.4470737_f32;
        let v168 = s[0] * 1.0497155_f32;
        let v170 = s[1] * 4.5926456_f32;
        let v171 = v168 + v170;
        let v173 = s[2] * 1.7125864_f32;
        let v174 = v171 + v173;
        let v176 = s[3] * -1.2706293_f32;
        let v177 = v174 + v176;
        let v179 = s[4] * 0.04261334_f32;
        let v180 = v177 + v179;
        let v182 = s[5] * -0.1246854_f32;
        let v183 = v180 + v182;
        let v185 = s[6] * 0.022234725_f32;
        let v186 = v183 + v185;
        let v188 = s[7] * 0.29823032_f32;
        let v189 = v186 + v188;
        let v191 = s[8] * -0.003917866_f32;
        let v192 = v189 + v191;
        let v194 = s[9] * -0.1538466_f32;
        let v195 = v192 + v194;
        let v197 = s[10] * -0.49762392_f32;
        let v198 = v195 + v197;
        let v200 = s[11] * 0.19477585_f32;
        let v201 = v198 + v200;
        let v203 = s[12] * -0.017092187_f32;
        let v204 = v201 + v203;
        let v206 = s[13] * -0.31458244_f32;
        let v207 = v204 + v206;
        let v209 = s[14] * 6.3393784_f32;
        let v210 = v207 + v209;
        let v212 = s[15] * 2.131467_f32;
        let v213 = v210 + v212;
        let v215 = s[16] * 1.6827623_f32;
        let v216 = v213 + v215;
        let v218 = s[17] * -2.958541_f32;
        let v219 = v216 + v218;
        let v221 = s[18] * 2.4626467_f32;
        let v222 = v219 + v221;
        let v224 = s[19] * 1.1390029_f32;
        let v225 = v222 + v224;
        let v227 = s[20] * -1.7571104_f32;
        let v228 = v225 + v227;
        let v230 = s[21] * 1.0455837_f32;
        let v231 = v228 + v230;
        let v233 = s[22] * 0.4267561_f32;
        let v234 = v231 + v233;
        let v236 = s[23] * -11.318814_f32;
        let v237 = v234 + v236;
        let v239 = v237 + 6.3224926_f32;
        let v241 = s[0] * 0.4515603_f32;
        let v243 = s[1] * 14.720121_f32;
        let v244 = v241 + v243;
        let v246 = s[2] * 0.44103858_f32;
        let v247 = v244 + v246;
        let v249 = s[3] * -1.2183368_f32;
        let v250 = v247 + v249;
        let v252 = s[4] * -0.250826_f32;
        let v253 = v250 + v252;
        let v255 = s[5] * 0.49178404_f32;
        let v256 = v253 + v255;
        let v258 = s[6] * -0.3779984_f32;
        let v259 = v256 + v258;
        let v261 = s[7] * -0.0028148007_f32;
        let v262 = v259 + v261;
        let v264 = s[8] * 0.06386011_f32;
        let v265 = v262 + v264;
        let v267 = s[9] * -0.041378263_f32;
        let v268 = v265 + v267;
        let v270 = s[10] * -0.19922008_f32;
        let v271 = v268 + v270;
        let v273 = s[11] * -1.1892239_f32;
        let v274 = v271 + v273;
        let v276 = s[12] * -0.49735847_f32;
        let v277 = v274 + v276;
        let v279 = s[13] * 0.43485624_f32;
        let v280 = v277 + v279;
        let v282 = s[14] * -5.629588_f32;
        let v283 = v280 + v282;
        let v285 = s[15] * 1.6327361_f32;
        let v286 = v283 + v285;
        let v288 = s[16] * 3.8373559_f32;
        let v289 = v286 + v288;
        let v291 = s[17] * -0.42398152_f32;
        let v292 = v289 + v291;
        let v294 = s[18] * -2.8770363_f32;
        let v295 = v292 + v294;
        let v297 = s[19] * -0.4884606_f32;
        let v298 = v295 + v297;
        let v300 = s[20] * -2.4138744_f32;
        let v301 = v298 + v300;
        let v303 = s[21] * -0.7583262_f32;
        let v304 = v301 + v303;
        let v306 = s[22] * 0.5175674_f32;
        let v307 = v304 + v306;
        let v309 = s[23] * -4.1500196_f32;
        let v310 = v307 + v309;
        let v312 = v310 + 6.9373_f32;
        [
            ct.clamp(v92, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v166, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v239, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v312, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
