//! Finds the first number of a result that is not finite.

use std::fmt::{Arguments, Error as Stop, Write};

use serde::Serialize;
use serde::ser::{
    SerializeMap, SerializeSeq, SerializeStruct, SerializeStructVariant, SerializeTuple,
    SerializeTupleStruct, SerializeTupleVariant, Serializer,
};

/// The place of the first number that is not finite, as people write it: `checks[3].residual`.
pub(super) fn place<T: Serialize + ?Sized>(result: &T) -> Option<String> {
    let mut finder = Finder { path: String::new() };
    result.serialize(&mut finder).is_err().then(|| finder.path.trim_start_matches('.').to_owned())
}

/// Goes through a result; stops at a number that is not finite, with its path.
struct Finder {
    path: String,
}

impl Finder {
    /// Goes through a part; its step stays in the path where the search ends there.
    fn part<T: Serialize + ?Sized>(&mut self, step: Arguments<'_>, part: &T) -> Result<(), Stop> {
        let length = self.path.len();
        // Writing to a text does not fail.
        let _ = self.path.write_fmt(step);
        part.serialize(&mut *self)?;
        self.path.truncate(length);
        Ok(())
    }
}

/// The parts of a list or of an object.
struct Parts<'a> {
    finder: &'a mut Finder,
    count: usize,
    key: String,
}

impl Parts<'_> {
    /// Goes through the part of a key; without one, through the next item.
    fn part<T: Serialize + ?Sized>(&mut self, key: Option<&str>, part: &T) -> Result<(), Stop> {
        if let Some(key) = key {
            return self.finder.part(format_args!(".{key}"), part);
        }
        self.count += 1;
        self.finder.part(format_args!("[{}]", self.count - 1), part)
    }
}

/// Values without parts are finite.
macro_rules! finite {
    ($($method:ident($($type:ty),*))*) => { $(
        fn $method(self, $(_: $type),*) -> Result<(), Stop> {
            Ok(())
        }
    )* };
}

/// Values with parts.
macro_rules! parts {
    ($($method:ident($($type:ty),*))*) => { $(
        fn $method(self, $(_: $type),*) -> Result<Parts<'a>, Stop> {
            Ok(Parts { finder: self, count: 0, key: String::new() })
        }
    )* };
}

impl<'a> Serializer for &'a mut Finder {
    type Ok = ();
    type Error = Stop;
    type SerializeSeq = Parts<'a>;
    type SerializeTuple = Parts<'a>;
    type SerializeTupleStruct = Parts<'a>;
    type SerializeTupleVariant = Parts<'a>;
    type SerializeMap = Parts<'a>;
    type SerializeStruct = Parts<'a>;
    type SerializeStructVariant = Parts<'a>;

    finite! {
        serialize_bool(bool) serialize_char(char) serialize_str(&str) serialize_bytes(&[u8]) serialize_unit() serialize_none()
        serialize_unit_struct(&'static str) serialize_unit_variant(&'static str, u32, &'static str)
        serialize_i8(i8) serialize_i16(i16) serialize_i32(i32) serialize_i64(i64)
        serialize_u8(u8) serialize_u16(u16) serialize_u32(u32) serialize_u64(u64)
    }

    parts! {
        serialize_seq(Option<usize>) serialize_map(Option<usize>) serialize_tuple(usize)
        serialize_tuple_struct(&'static str, usize) serialize_struct(&'static str, usize)
        serialize_tuple_variant(&'static str, u32, &'static str, usize)
        serialize_struct_variant(&'static str, u32, &'static str, usize)
    }

    fn serialize_f32(self, value: f32) -> Result<(), Stop> {
        self.serialize_f64(value.into())
    }

    fn serialize_f64(self, value: f64) -> Result<(), Stop> {
        if value.is_finite() { Ok(()) } else { Err(Stop) }
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), Stop> {
        value.serialize(self)
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(self, _: &'static str, value: &T) -> Result<(), Stop> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<(), Stop> {
        self.part(format_args!(".{variant}"), value)
    }
}

/// Lists of all sorts, and structures, whose parts have keys.
macro_rules! compounds {
    ($($compound:ident: $method:ident($($key:ident)?))*) => { $(
        impl $compound for Parts<'_> {
            type Ok = ();
            type Error = Stop;

            fn $method<T: Serialize + ?Sized>(&mut self, $($key: &'static str,)? part: &T) -> Result<(), Stop> {
                self.part(None$(.or(Some($key)))?, part)
            }

            fn end(self) -> Result<(), Stop> {
                Ok(())
            }
        }
    )* };
}

compounds! {
    SerializeSeq: serialize_element()
    SerializeTuple: serialize_element()
    SerializeTupleStruct: serialize_field()
    SerializeTupleVariant: serialize_field()
    SerializeStruct: serialize_field(key)
    SerializeStructVariant: serialize_field(key)
}

impl SerializeMap for Parts<'_> {
    type Ok = ();
    type Error = Stop;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Stop> {
        let text = serde_json::to_value(key).unwrap_or_default();
        self.key = text.as_str().map_or_else(|| text.to_string(), str::to_owned);
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Stop> {
        let key = std::mem::take(&mut self.key);
        self.part(Some(&key), value)
    }

    fn end(self) -> Result<(), Stop> {
        Ok(())
    }
}
