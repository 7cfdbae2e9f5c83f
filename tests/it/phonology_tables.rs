//! The inventories of grammar/ hold every row of the tables that they were made from (../shared/data/phonology).

use crate::shared::{column, shared};
use chereme::phonology::LocationInventory;

#[test]
fn every_place_of_the_table_is_in_the_grammar() {
    let Some(table) = shared("data/phonology/locations.tsv") else { return };
    let (ids, tags) = (column(&table, "id"), column(&table, "hamnosys"));
    assert_eq!(ids.len(), 44);
    let places = LocationInventory::builtin();
    for (id, tag) in ids.iter().zip(&tags) {
        let known = places.get(id).is_some() || places.by_tag(tag).is_some();
        assert!(known, "{id} ({tag}) is not in grammar/locations.ron");
    }
}
