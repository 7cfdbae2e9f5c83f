//! The joint angles of a hand.

use crate::phonology::Digit;

/// The angles of one finger, radians.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FingerAngles {
    /// Flexion at the knuckle, toward the palm.
    pub mcp: f64,
    /// Away from the middle finger; for the middle finger toward the thumb.
    pub abduction: f64,
    /// Flexion at the middle joint.
    pub pip: f64,
    /// Flexion at the last joint.
    pub dip: f64,
}

impl FingerAngles {
    /// Each angle a part of the way to another finger's, or beyond.
    pub fn lerp(&self, to: &FingerAngles, w: f64) -> FingerAngles {
        let mix = |a: f64, b: f64| a + (b - a) * w;
        FingerAngles {
            mcp: mix(self.mcp, to.mcp),
            abduction: mix(self.abduction, to.abduction),
            pip: mix(self.pip, to.pip),
            dip: mix(self.dip, to.dip),
        }
    }
}

/// The angles of the thumb, radians.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ThumbAngles {
    /// Metacarpal away from the index, in the plane of the palm.
    pub radial: f64,
    /// Metacarpal out of the plane of the palm.
    pub palmar: f64,
    /// Turn of the flexion axis about the metacarpal, so that the pad comes to face the fingers.
    pub pronation: f64,
    /// Flexion at the knuckle.
    pub mcp: f64,
    /// Flexion at the last joint.
    pub ip: f64,
}

impl ThumbAngles {
    /// Each angle a part of the way to another thumb's, or beyond.
    pub fn lerp(&self, to: &ThumbAngles, w: f64) -> ThumbAngles {
        let mix = |a: f64, b: f64| a + (b - a) * w;
        ThumbAngles {
            radial: mix(self.radial, to.radial),
            palmar: mix(self.palmar, to.palmar),
            pronation: mix(self.pronation, to.pronation),
            mcp: mix(self.mcp, to.mcp),
            ip: mix(self.ip, to.ip),
        }
    }
}

/// The angles of a whole hand, radians; the same numbers make a left or a right hand.
///
/// ```
/// use chereme::phonology::handshape::HandAngles;
/// let (flat, mut fist) = (HandAngles::default(), HandAngles::default());
/// fist.fingers[0].pip = 1.8;
/// assert_eq!(flat.lerp(&fist, 0.5).fingers[0].pip, 0.9);
/// assert_eq!(flat.max_difference(&fist), 1.8);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct HandAngles {
    /// Index, middle, ring and little finger.
    pub fingers: [FingerAngles; 4],
    /// The thumb.
    pub thumb: ThumbAngles,
}

impl HandAngles {
    /// How many angles a hand has.
    pub const COUNT: usize = 21;

    /// A finger's angles; `None` for the thumb.
    pub fn finger(&self, digit: Digit) -> Option<&FingerAngles> {
        Digit::FINGERS.iter().position(|d| *d == digit).map(|i| &self.fingers[i])
    }

    /// All angles: for each finger MCP, abduction, PIP, DIP; then the thumb's five.
    pub fn to_array(&self) -> [f64; HandAngles::COUNT] {
        let [a, b, c, d] = self.fingers.map(|f| [f.mcp, f.abduction, f.pip, f.dip]);
        let t = &self.thumb;
        let thumb = [t.radial, t.palmar, t.pronation, t.mcp, t.ip];
        std::array::from_fn(|i| match i / 4 {
            0 => a[i],
            1 => b[i - 4],
            2 => c[i - 8],
            3 => d[i - 12],
            _ => thumb[i - 16],
        })
    }

    /// The inverse of [`HandAngles::to_array`].
    pub fn from_array(a: [f64; HandAngles::COUNT]) -> HandAngles {
        let finger =
            |i: usize| FingerAngles { mcp: a[4 * i], abduction: a[4 * i + 1], pip: a[4 * i + 2], dip: a[4 * i + 3] };
        HandAngles {
            fingers: std::array::from_fn(finger),
            thumb: ThumbAngles { radial: a[16], palmar: a[17], pronation: a[18], mcp: a[19], ip: a[20] },
        }
    }

    /// Each angle a part of the way to another hand's.
    pub fn lerp(&self, to: &HandAngles, w: f64) -> HandAngles {
        let (a, b) = (self.to_array(), to.to_array());
        HandAngles::from_array(std::array::from_fn(|i| a[i] + (b[i] - a[i]) * w))
    }

    /// The greatest difference of an angle, radians.
    pub fn max_difference(&self, other: &HandAngles) -> f64 {
        let (a, b) = (self.to_array(), other.to_array());
        a.iter().zip(b).map(|(p, q)| (p - q).abs()).fold(0.0, f64::max)
    }
}
