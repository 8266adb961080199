"""What a group is: a basis, from which hat, vee, ad, Ad and coad follow."""
