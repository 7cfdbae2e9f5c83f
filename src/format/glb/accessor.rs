//! Accessors: arrays of numbers in the binary chunk, plain or sparse, in any of glTF's number types.

use super::document::{Accessor, Document};
use crate::diagnostics::Error;

/// The most numbers read out of one file (128 MB of them): accessors may share bytes or have none,
/// so a small file could otherwise ask for any amount of memory.
const MOST_NUMBERS: usize = 16_000_000;

/// Reads accessors of one file.
pub(super) struct Arrays<'a> {
    document: &'a Document,
    bin: &'a [u8],
    left: usize,
}

impl<'a> Arrays<'a> {
    pub(super) fn new(document: &'a Document, bin: &'a [u8]) -> Arrays<'a> {
        Arrays { document, bin, left: MOST_NUMBERS }
    }

    /// How many elements an accessor has.
    pub(super) fn count(&self, index: usize) -> Result<usize, Error> {
        self.accessor(index).map(|a| a.count)
    }

    fn accessor(&self, index: usize) -> Result<&'a Accessor, Error> {
        self.document.accessors.get(index).ok_or_else(|| Error::new(format!("the GLB file has no accessor {index}")))
    }

    /// Elements of `N` numbers each; `shape` is glTF's word for that ("SCALAR", "VEC3", ...).
    /// Every number is finite. `count` is the number of elements that there have to be.
    pub(super) fn elements<const N: usize>(
        &mut self,
        index: usize,
        shape: &str,
        count: usize,
    ) -> Result<Vec<[f64; N]>, Error> {
        let accessor = self.accessor(index)?;
        let fault = |what: &str| Error::new(format!("accessor {index} of the GLB file {what}"));
        if accessor.shape != shape {
            return Err(fault(&format!("should hold {shape}, and holds {}", accessor.shape)));
        }
        if accessor.count != count {
            return Err(fault(&format!("should have {count} elements, and has {}", accessor.count)));
        }
        let sparse = accessor.sparse.as_ref().map_or(0, |s| s.count);
        self.left = count
            .checked_add(sparse)
            .and_then(|n| n.checked_mul(N))
            .and_then(|n| self.left.checked_sub(n))
            .ok_or_else(|| fault(&format!("is too large: more than {MOST_NUMBERS} numbers in one file")))?;
        let kind = Kind::of(accessor.component_type, accessor.normalized)
            .ok_or_else(|| fault(&format!("has an unknown component type, {}", accessor.component_type)))?;
        let mut elements = match accessor.buffer_view {
            None => vec![[0.0; N]; count],
            Some(view) => self
                .view(view, accessor.byte_offset, kind, count)
                .ok_or_else(|| fault("reaches beyond the end of its buffer"))?,
        };
        if let Some(sparse) = &accessor.sparse {
            let index_kind = sparse.indices.component_type.and_then(|c| Kind::of(c, false));
            let places = index_kind
                .and_then(|k| self.view::<1>(sparse.indices.buffer_view, sparse.indices.byte_offset, k, sparse.count));
            let values = self.view::<N>(sparse.values.buffer_view, sparse.values.byte_offset, kind, sparse.count);
            let (Some(places), Some(values)) = (places, values) else {
                return Err(fault("has sparse values beyond the end of their buffer"));
            };
            for ([place], value) in places.into_iter().zip(values) {
                *elements.get_mut(place as usize).ok_or_else(|| fault("has a sparse value past its end"))? = value;
            }
        }
        if elements.iter().flatten().all(|n| n.is_finite()) {
            Ok(elements)
        } else {
            Err(fault("holds a number that is not finite"))
        }
    }

    /// Elements out of a buffer view, or `None` where they reach beyond it or beyond the file.
    fn view<const N: usize>(&self, view: usize, offset: usize, kind: Kind, count: usize) -> Option<Vec<[f64; N]>> {
        let view = self.document.buffer_views.get(view).filter(|v| v.buffer == 0)?;
        let end = view.byte_offset.checked_add(view.byte_length)?;
        let bytes = self.bin.get(view.byte_offset..end)?.get(offset..)?;
        let size = kind.size() * N;
        let stride = view.byte_stride.unwrap_or(size).max(size);
        let needed = count.checked_sub(1).map_or(Some(0), |n| n.checked_mul(stride)?.checked_add(size))?;
        if needed > bytes.len() {
            return None;
        }
        let element = |i: usize| std::array::from_fn(|k| kind.number(&bytes[i * stride + k * kind.size()..]));
        Some((0..count).map(element).collect())
    }
}

/// The number types of glTF; the normalised ones stand for 0..1 or −1..1.
#[derive(Debug, Clone, Copy)]
enum Kind {
    I8 { normalized: bool },
    U8 { normalized: bool },
    I16 { normalized: bool },
    U16 { normalized: bool },
    U32,
    F32,
}

impl Kind {
    fn of(component_type: u32, normalized: bool) -> Option<Kind> {
        Some(match component_type {
            5120 => Kind::I8 { normalized },
            5121 => Kind::U8 { normalized },
            5122 => Kind::I16 { normalized },
            5123 => Kind::U16 { normalized },
            5125 => Kind::U32,
            5126 => Kind::F32,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Kind::I8 { .. } | Kind::U8 { .. } => 1,
            Kind::I16 { .. } | Kind::U16 { .. } => 2,
            Kind::U32 | Kind::F32 => 4,
        }
    }

    /// The number at the start of `b`, which has at least `size` bytes.
    fn number(self, b: &[u8]) -> f64 {
        let part = |normalized: bool, value: f64, most: f64| if normalized { (value / most).max(-1.0) } else { value };
        match self {
            Kind::I8 { normalized } => part(normalized, f64::from(b[0] as i8), 127.0),
            Kind::U8 { normalized } => part(normalized, f64::from(b[0]), 255.0),
            Kind::I16 { normalized } => part(normalized, f64::from(i16::from_le_bytes([b[0], b[1]])), 32767.0),
            Kind::U16 { normalized } => part(normalized, f64::from(u16::from_le_bytes([b[0], b[1]])), 65535.0),
            Kind::U32 => f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            Kind::F32 => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
        }
    }
}
