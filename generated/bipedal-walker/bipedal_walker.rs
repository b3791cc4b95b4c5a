//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix bipedal_walker --profile constant-time
//! Graph SHA-256: 9d8c42d624c3770a63b707f660b7746c1bc1c049e8b73961774134beff3c0e09
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 194 distinct operations.
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
    pub const WORST_OPERATIONS: usize = 194;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for BipedalWalker {
    type State = [f32; 24];
    type Action = [f32; 4];

    fn decide(&self, s: &[f32; 24]) -> [f32; 4] {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[0] * 0.5046787_f32;
        let v4 = 0.0_f32 + v3;
        let v7 = s[1] * 8.018429_f32;
        let v8 = v4 + v7;
        let v11 = s[2] * 1.1309677_f32;
        let v12 = v8 + v11;
        let v15 = s[3] * 1.3572947_f32;
        let v16 = v12 + v15;
        let v19 = s[4] * -1.4042757_f32;
        let v20 = v16 + v19;
        let v23 = s[5] * -0.20148475_f32;
        let v24 = v20 + v23;
        let v27 = s[7] * -0.15425919_f32;
        let v28 = v24 + v27;
        let v31 = s[8] * 0.22009312_f32;
        let v32 = v28 + v31;
        let v35 = s[9] * 0.7223859_f32;
        let v36 = v32 + v35;
        let v39 = s[10] * 0.05046511_f32;
        let v40 = v36 + v39;
        let v43 = s[11] * -0.47640488_f32;
        let v44 = v40 + v43;
        let v47 = s[12] * 0.33258402_f32;
        let v48 = v44 + v47;
        let v51 = s[13] * -0.14858565_f32;
        let v52 = v48 + v51;
        let v55 = s[14] * 0.7674586_f32;
        let v56 = v52 + v55;
        let v59 = s[15] * -0.17519812_f32;
        let v60 = v56 + v59;
        let v63 = s[16] * 1.8191909_f32;
        let v64 = v60 + v63;
        let v67 = s[17] * 1.8449576_f32;
        let v68 = v64 + v67;
        let v71 = s[18] * -2.8432984_f32;
        let v72 = v68 + v71;
        let v75 = s[19] * -0.18586843_f32;
        let v76 = v72 + v75;
        let v79 = s[20] * -0.771481_f32;
        let v80 = v76 + v79;
        let v83 = s[21] * 1.6962188_f32;
        let v84 = v80 + v83;
        let v87 = s[22] * 1.1837615_f32;
        let v88 = v84 + v87;
        let v91 = s[23] * -6.4229074_f32;
        let v92 = v88 + v91;
        let v94 = v92 + 2.5260677_f32;
        let v96 = s[0] * 1.8828421_f32;
        let v97 = 0.0_f32 + v96;
        let v99 = s[1] * 8.03671_f32;
        let v100 = v97 + v99;
        let v102 = s[2] * -0.094880946_f32;
        let v103 = v100 + v102;
        let v105 = s[3] * -2.3845007_f32;
        let v106 = v103 + v105;
        let v108 = s[4] * 0.6801684_f32;
        let v109 = v106 + v108;
        let v111 = s[5] * -0.04494099_f32;
        let v112 = v109 + v111;
        let v115 = s[6] * -0.5763401_f32;
        let v116 = v112 + v115;
        let v118 = s[7] * -0.1844264_f32;
        let v119 = v116 + v118;
        let v121 = s[8] * -0.035329953_f32;
        let v122 = v119 + v121;
        let v124 = s[9] * 0.8470248_f32;
        let v125 = v122 + v124;
        let v127 = s[10] * 0.13221936_f32;
        let v128 = v125 + v127;
        let v130 = s[11] * 0.72477835_f32;
        let v131 = v128 + v130;
        let v133 = s[12] * 0.15656033_f32;
        let v134 = v131 + v133;
        let v136 = s[13] * 0.18303227_f32;
        let v137 = v134 + v136;
        let v139 = s[14] * -0.9859452_f32;
        let v140 = v137 + v139;
        let v142 = s[15] * -1.3015733_f32;
        let v143 = v140 + v142;
        let v145 = s[16] * -1.0328742_f32;
        let v146 = v143 + v145;
        let v148 = s[17] * -2.4927297_f32;
        let v149 = v146 + v148;
        let v151 = s[18] * 1.37519_f32;
        let v152 = v149 + v151;
        let v154 = s[19] * -2.2172704_f32;
        let v155 = v152 + v154;
        let v157 = s[20] * 1.180808_f32;
        let v158 = v155 + v157;
        let v160 = s[21] * -1.329915_f32;
        let v161 = v158 + v160;
        let v163 = s[22] * -0.25188348_f32;
        let v164 = v161 + v163;
        let v166 = s[23] * 6.103324_f32;
        let v167 = v164 + v166;
        let v169 = v167 + -2.4470737_f32;
        let v171 = s[0] * 1.0497155_f32;
        let v172 = 0.0_f32 + v171;
        let v174 = s[1] * 4.5926456_f32;
        let v175 = v172 + v174;
        let v177 = s[2] * 1.7125864_f32;
        let v178 = v175 + v177;
        let v180 = s[3] * -1.2706293_f32;
        let v181 = v178 + v180;
        let v183 = s[4] * 0.04261334_f32;
        let v184 = v181 + v183;
        let v186 = s[5] * -0.1246854_f32;
        let v187 = v184 + v186;
        let v189 = s[6] * 0.022234725_f32;
        let v190 = v187 + v189;
        let v192 = s[7] * 0.29823032_f32;
        let v193 = v190 + v192;
        let v195 = s[8] * -0.003917866_f32;
        let v196 = v193 + v195;
        let v198 = s[9] * -0.1538466_f32;
        let v199 = v196 + v198;
        let v201 = s[10] * -0.49762392_f32;
        let v202 = v199 + v201;
        let v204 = s[11] * 0.19477585_f32;
        let v205 = v202 + v204;
        let v207 = s[12] * -0.017092187_f32;
        let v208 = v205 + v207;
        let v210 = s[13] * -0.31458244_f32;
        let v211 = v208 + v210;
        let v213 = s[14] * 6.3393784_f32;
        let v214 = v211 + v213;
        let v216 = s[15] * 2.131467_f32;
        let v217 = v214 + v216;
        let v219 = s[16] * 1.6827623_f32;
        let v220 = v217 + v219;
        let v222 = s[17] * -2.958541_f32;
        let v223 = v220 + v222;
        let v225 = s[18] * 2.4626467_f32;
        let v226 = v223 + v225;
        let v228 = s[19] * 1.1390029_f32;
        let v229 = v226 + v228;
        let v231 = s[20] * -1.7571104_f32;
        let v232 = v229 + v231;
        let v234 = s[21] * 1.0455837_f32;
        let v235 = v232 + v234;
        let v237 = s[22] * 0.4267561_f32;
        let v238 = v235 + v237;
        let v240 = s[23] * -11.318814_f32;
        let v241 = v238 + v240;
        let v243 = v241 + 6.3224926_f32;
        let v245 = s[0] * 0.4515603_f32;
        let v246 = 0.0_f32 + v245;
        let v248 = s[1] * 14.720121_f32;
        let v249 = v246 + v248;
        let v251 = s[2] * 0.44103858_f32;
        let v252 = v249 + v251;
        let v254 = s[3] * -1.2183368_f32;
        let v255 = v252 + v254;
        let v257 = s[4] * -0.250826_f32;
        let v258 = v255 + v257;
        let v260 = s[5] * 0.49178404_f32;
        let v261 = v258 + v260;
        let v263 = s[6] * -0.3779984_f32;
        let v264 = v261 + v263;
        let v266 = s[7] * -0.0028148007_f32;
        let v267 = v264 + v266;
        let v269 = s[8] * 0.06386011_f32;
        let v270 = v267 + v269;
        let v272 = s[9] * -0.041378263_f32;
        let v273 = v270 + v272;
        let v275 = s[10] * -0.19922008_f32;
        let v276 = v273 + v275;
        let v278 = s[11] * -1.1892239_f32;
        let v279 = v276 + v278;
        let v281 = s[12] * -0.49735847_f32;
        let v282 = v279 + v281;
        let v284 = s[13] * 0.43485624_f32;
        let v285 = v282 + v284;
        let v287 = s[14] * -5.629588_f32;
        let v288 = v285 + v287;
        let v290 = s[15] * 1.6327361_f32;
        let v291 = v288 + v290;
        let v293 = s[16] * 3.8373559_f32;
        let v294 = v291 + v293;
        let v296 = s[17] * -0.42398152_f32;
        let v297 = v294 + v296;
        let v299 = s[18] * -2.8770363_f32;
        let v300 = v297 + v299;
        let v302 = s[19] * -0.4884606_f32;
        let v303 = v300 + v302;
        let v305 = s[20] * -2.4138744_f32;
        let v306 = v303 + v305;
        let v308 = s[21] * -0.7583262_f32;
        let v309 = v306 + v308;
        let v311 = s[22] * 0.5175674_f32;
        let v312 = v309 + v311;
        let v314 = s[23] * -4.1500196_f32;
        let v315 = v312 + v314;
        let v317 = v315 + 6.9373_f32;
        [
            ct.clamp(v94, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v169, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v243, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v317, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
