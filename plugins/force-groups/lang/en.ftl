force-groups = group by group from the last to the input link: every reaction and the balancing load
    .source = S stage 9: kinetostatics of Assur groups
    .wording = group by group, from the last Assur group back to the input link
