//! What the parts say of texts: single cases, then whatever comes.

mod difference;
mod edit;
mod names;
mod readable;
mod whatever;
